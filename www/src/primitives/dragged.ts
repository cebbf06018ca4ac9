/** What a primitive is known by while it is dragged. */
export const DRAGGED = "application/x-vcgpdm-primitive";
