//! An evaluation of the bound with its gradient allocates nothing once its workspace is there.
#![cfg(not(target_arch = "wasm32"))]
#![allow(unsafe_code, clippy::unwrap_used)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};
use vcgpdm::models::variational::VariationalTrainer;
use vcgpdm::models::{Dataset, Source, VariationalSettings};
use vcgpdm::motion::{parts, samples};

struct Counting;

static COUNT: AtomicUsize = AtomicUsize::new(0);

// SAFETY: everything is forwarded to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.fetch_add(1, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn an_evaluation_allocates_nothing() {
    let clip = samples::clip("walk-1").unwrap();
    let parts = parts::presets(&clip.skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap().parts;
    let dataset = Dataset::new(&[Source { clip: &clip, first_frames: None }], &parts, 30.0).unwrap();
    let trainer =
        VariationalTrainer::new(dataset.y.clone(), dataset.lengths(), &VariationalSettings::default(), 0)
            .unwrap();
    let (objective, params) = (trainer.objective(), trainer.best());
    let mut workspace = objective.workspace(&params);
    objective.compute_with_gradient(&params, &mut workspace).unwrap();
    let before = COUNT.load(Ordering::Relaxed);
    for _ in 0..3 {
        objective.compute_with_gradient(&params, &mut workspace).unwrap();
    }
    assert_eq!(COUNT.load(Ordering::Relaxed) - before, 0);
}
