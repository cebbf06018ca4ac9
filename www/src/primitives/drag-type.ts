/** What a primitive is known by while it is dragged. */
export const DRAG_TYPE = "application/x-vcgpdm-primitive";
