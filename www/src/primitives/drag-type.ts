/** The data type of a dragged primitive. */
export const DRAG_TYPE = "application/x-vcgpdm-primitive";
