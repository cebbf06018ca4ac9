//! Ctrl-C, or a scheduler's SIGTERM, as a request to stop and keep the best result so far.

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::error::Error;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Becomes true at the first Ctrl-C or SIGTERM (the end of a Slurm job's time). A second one ends the program
/// at once. SIGHUP, the end of the terminal, keeps its default action, so that `nohup` can switch it off.
pub fn flag() -> Result<Arc<AtomicBool>, Box<dyn Error>> {
    let stopped = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        // The order matters: at the first signal the flag must still be false.
        flag::register_conditional_shutdown(signal, 1, Arc::clone(&stopped))?;
        flag::register(signal, Arc::clone(&stopped))?;
    }
    Ok(stopped)
}
