//! The examples of the library `vcgpdm`, in `crate/vcgpdm/examples`. Cargo compiles the test packages of a library
//! for its examples; from here they need the library alone.
