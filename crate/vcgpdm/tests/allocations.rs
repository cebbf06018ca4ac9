//! Memory allocations of an evaluation of the bound and of a training step.
#![cfg(not(target_arch = "wasm32"))]
#![allow(unsafe_code, clippy::unwrap_used)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};
use vcgpdm_core::models::variational::VariationalTrainer;
use vcgpdm_core::models::{Dataset, Source, VariationalSettings};
use vcgpdm_core::motion::{parts, samples};

struct Counting;

static COUNT: AtomicUsize = AtomicUsize::new(0);

// SAFETY: the system's allocator does all work.
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

/// The only test of this program, because the allocations of a second test would be counted too.
#[test]
fn neither_an_evaluation_nor_a_training_step_allocates() {
    let clip = samples::clip("walk-1").unwrap();
    let parts = parts::presets(&clip.skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap().parts;
    let dataset = Dataset::new(&[Source { clip: &clip, first_frames: None }], &parts, 30.0).unwrap();
    let settings = VariationalSettings { max_iterations: 80, ..VariationalSettings::default() };
    let mut trainer = VariationalTrainer::new(dataset.y.clone(), dataset.lengths(), &settings, 0).unwrap();
    let (objective, params) = (trainer.objective(), trainer.best());
    let mut workspace = objective.workspace(&params);
    objective.compute_with_gradient(&params, &mut workspace).unwrap();
    let count = |work: &mut dyn FnMut()| {
        let before = COUNT.load(Ordering::Relaxed);
        work();
        COUNT.load(Ordering::Relaxed) - before
    };
    assert_eq!(count(&mut || objective.compute_with_gradient(&params, &mut workspace).unwrap()), 0);

    // The first phase ends after ten steps, and each phase begins with memory of its own.
    (0..12).for_each(|_| drop(trainer.step()));
    let progress = count(&mut || drop(trainer.progress()));
    for _ in 0..60 {
        // A step returns the progress, which holds copies of the terms of the bound.
        assert_eq!(count(&mut || drop(trainer.step())), progress);
    }
}
