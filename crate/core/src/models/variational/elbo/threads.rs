//! The maps of all parts, in several threads.
//!
//! All sums have the same order as in one thread, so that a model is the same to the last bit. Therefore
//! there are two rounds: first every map by itself, then, part by part, the gradient with respect to the
//! histories, from all experts of the part.

use crate::gp::linalg::{add_jittered, counting_jittered};
use crate::gp::psi::Purpose;
use crate::gp::{Gaussians, NumericsError};
use crate::models::variational::elbo::dynamics::SourceRows;
use crate::models::variational::elbo::objective::Objective;
use crate::models::variational::elbo::{PairWorkspaces, Workspace};
use crate::models::variational::params::Params;
use std::panic::resume_unwind;
use std::sync::{Mutex, PoisonError};
use std::thread;

type Task<'a> = Box<dyn FnOnce() -> Result<(), NumericsError> + Send + 'a>;

impl Workspace {
    /// Computes gradients in `threads` threads from now on, with separate memory for each part. The result is
    /// the same to the last bit.
    pub fn use_threads(&mut self, threads: usize) {
        self.threads = threads.max(1);
        let (movements, parts) = (self.histories.len(), self.kinematics.len());
        let workspaces = if threads > 1 { parts } else { 1 };
        self.workspaces.resize_with(workspaces, || PairWorkspaces::new(movements, parts));
    }
}

impl Objective {
    /// [`add_maps`](Self::add_maps) in several threads.
    pub(super) fn add_maps_in_threads(
        &self,
        params: &Params,
        workspace: &mut Workspace,
    ) -> Result<(), NumericsError> {
        self.adjoints(params, workspace)?;
        self.pull_back(params, workspace)?;
        for dynamics in &workspace.dynamics {
            dynamics.add_gradient(self, params, &mut workspace.gradient);
        }
        Ok(())
    }

    /// The first round: each map with its adjoint.
    fn adjoints(&self, params: &Params, workspace: &mut Workspace) -> Result<(), NumericsError> {
        let Workspace { terms, histories, kinematics, dynamics, workspaces, threads, .. } = workspace;
        let histories = &*histories;
        let (mut tasks, mut poses): (Vec<Task>, Vec<Task>) = (Vec::new(), Vec::new());
        let terms = terms.kinematics.iter_mut().zip(&mut terms.dynamics);
        let maps = kinematics.iter_mut().zip(dynamics).zip(workspaces).zip(terms);
        for (i, (((kinematics, dynamics), workspaces), (pose_term, term))) in maps.enumerate() {
            let PairWorkspaces { pose, dynamics: workspaces } = workspaces;
            tasks.push(Box::new(move || {
                dynamics.compute(self, params, histories, Purpose::Gradient, workspaces);
                *term = dynamics.adjoint(self, params)?;
                Ok(())
            }));
            poses.push(Box::new(move || {
                kinematics.compute(self, params, i, Purpose::Gradient, pose);
                *pose_term = kinematics.adjoint(self, params, i)?;
                Ok(())
            }));
        }
        // The largest tasks first: the threads then end at about the same time.
        tasks.append(&mut poses);
        run(*threads, tasks)
    }

    /// The second round: adjoints of the latents of each part through its pose map, and of its histories
    /// through all its experts.
    fn pull_back(&self, params: &Params, workspace: &mut Workspace) -> Result<(), NumericsError> {
        let Workspace {
            gradient,
            histories,
            histories_adjoint,
            kinematics,
            dynamics,
            workspaces,
            threads,
            ..
        } = workspace;
        let histories = &*histories;
        let parts = kinematics.len();
        let mut sources: Vec<Vec<SourceRows>> = (0..parts).map(|_| Vec::new()).collect();
        let mut into: Vec<Vec<&mut Gaussians>> = (0..parts).map(|_| Vec::new()).collect();
        for movement_adjoints in histories_adjoint {
            for (into, adjoint) in into.iter_mut().zip(movement_adjoints) {
                into.push(adjoint);
            }
        }
        let mut poses: Vec<Task> = Vec::new();
        let maps = kinematics.iter_mut().zip(dynamics).zip(workspaces);
        let latents = params.parts.iter().zip(&mut gradient.parts);
        for (((kinematics, dynamics), workspaces), (part, into)) in maps.zip(latents) {
            let PairWorkspaces { pose, dynamics: workspaces } = workspaces;
            poses.push(Box::new(move || {
                kinematics.pull_back(part, pose, into);
                Ok(())
            }));
            for (sources, source) in sources.iter_mut().zip(dynamics.by_source(self, workspaces)) {
                sources.push(source);
            }
        }
        let mut tasks: Vec<Task> = Vec::new();
        for (part, (sources, mut into)) in sources.into_iter().zip(into).enumerate() {
            tasks.push(Box::new(move || {
                for mut source in sources {
                    source.pull_back(params, part, histories, &mut into);
                }
                Ok(())
            }));
        }
        tasks.append(&mut poses);
        run(*threads, tasks)
    }
}

/// Runs the tasks on `threads` threads, this one included; each thread takes the next task. Returns the error
/// of the first task that has one.
fn run(threads: usize, tasks: Vec<Task>) -> Result<(), NumericsError> {
    let threads = threads.min(tasks.len());
    let left = Mutex::new(tasks.into_iter().enumerate());
    let work = || {
        let mut failed: Vec<(usize, NumericsError)> = Vec::new();
        let ((), jittered) = counting_jittered(|| {
            loop {
                // A separate statement releases the lock before the task runs.
                let next = left.lock().unwrap_or_else(PoisonError::into_inner).next();
                let Some((place, task)) = next else { break };
                failed.extend(task().err().map(|reason| (place, reason)));
            }
        });
        (failed, jittered)
    };
    let failed = thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(work)).collect();
        let (mut failed, _) = work();
        for other in others {
            let (too, jittered) = other.join().unwrap_or_else(|panic| resume_unwind(panic));
            failed.extend(too);
            add_jittered(jittered);
        }
        failed
    });
    failed.into_iter().min_by_key(|(place, _)| *place).map_or(Ok(()), |(_, reason)| Err(reason))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::search::parameters::Parameters;
    use crate::models::variational::repertoire::Repertoire;
    use crate::models::variational::testing::random_case;

    /// Two movements that share the primitive of the first part and have different ones of the second part.
    fn shared_case() -> (Params, Objective) {
        let (mut params, plain) = random_case(1);
        let movements = vec![(1, vec![0, 1]), (1, vec![0, 2])];
        let repertoire = Repertoire::new(plain.sequences().clone(), 2, vec![0, 1, 1], movements).unwrap();
        let mut other = params.experts[1].clone();
        other.iter_mut().for_each(|expert| expert.z *= 0.8);
        params.experts.push(other);
        params.alpha.push(&params.alpha[0] * 1.7);
        (params, Objective::of_movements(plain.observations().to_vec(), repertoire, 0.0))
    }

    /// Models of one, two and three parts and of two movements with a common primitive, in fewer and in more
    /// threads than maps.
    #[test]
    fn threads_compute_the_same_bits() {
        let bits = |params: &Params| params.to_flat().iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        let shared = shared_case();
        for (params, objective) in (0..4).map(random_case).chain([shared]) {
            let mut single = objective.workspace(&params);
            objective.compute_with_gradient(&params, &mut single).unwrap();
            for threads in [2, 3, 9] {
                let mut many = objective.workspace(&params);
                many.use_threads(threads);
                for _ in 0..2 {
                    objective.compute_with_gradient(&params, &mut many).unwrap();
                    assert_eq!(many.terms(), single.terms());
                    assert!(bits(many.gradient()) == bits(single.gradient()), "{threads} threads");
                }
            }
        }
    }

    #[test]
    fn reports_failures_and_jitter_of_other_threads() {
        let (mut params, objective) = random_case(1);
        let evaluate = |params: &Params, threads: usize| {
            let mut workspace = objective.workspace(params);
            workspace.use_threads(threads);
            counting_jittered(|| objective.compute_with_gradient(params, &mut workspace))
        };
        // Two equal inducing points: the covariance is singular.
        for expert in params.experts.iter_mut().flatten() {
            let first = expert.z.row(0).into_owned();
            expert.z.set_row(1, &first);
        }
        let (computed, jittered) = evaluate(&params, 1);
        assert!(computed.is_ok() && jittered > 0, "{computed:?}, {jittered}");
        assert_eq!(evaluate(&params, 2), (computed, jittered));
        params.parts[1].r[(0, 0)] = f64::NAN;
        assert!(evaluate(&params, 1).0.is_err());
        assert_eq!(evaluate(&params, 2).0, evaluate(&params, 1).0);
    }
}
