//! From primitives to a model of any combination of them.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetric};
use crate::gp::outputs::StoredOutputs;
use crate::models::couplings::{CouplingsError, check_couplings, coupling_weights};
use crate::models::library::{LearnedMovement, Library};
use crate::models::variational::{DynamicsSums, Elsewhere, FittedExpert, Vcgpdm, stack_offsets};
use nalgebra::DMatrix;
use thiserror::Error;

/// Why primitives cannot be combined as asked.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CombinationError {
    /// Not one primitive for each part.
    #[error("expected a primitive for each of {expected} parts, found {found}")]
    Count {
        /// Parts there are.
        expected: usize,
        /// Primitives named.
        found: usize,
    },
    /// A part is given what is not one of its primitives.
    #[error("expected a primitive of part {part}, found primitive {found}")]
    Primitive {
        /// The part, counted from 0.
        part: usize,
        /// What it was given, counted from 0.
        found: usize,
    },
    /// There is no such movement.
    #[error("expected a movement from 0 to {}, found {found}", count.saturating_sub(1))]
    Movement {
        /// Movements there are.
        count: usize,
        /// The one asked for, counted from 0.
        found: usize,
    },
    /// The couplings do not fit the parts.
    #[error(transparent)]
    Couplings(#[from] CouplingsError),
    /// The primitives cannot be solved for.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}

/// What is known about a stack of experts from rows: A - K and b / n.
struct Known {
    precision: DMatrix<f64>,
    b: DMatrix<f64>,
}

impl Library {
    /// The model of a movement, as it was learned.
    ///
    /// # Errors
    ///
    /// When there is no such movement, or a covariance cannot be factorised.
    pub fn movement(&self, index: usize) -> Result<Vcgpdm, CombinationError> {
        let count = self.movements.len();
        let movement = self.movements.get(index).ok_or(CombinationError::Movement { count, found: index })?;
        self.model(&movement.uses, &movement.alpha, Some(movement), movement.starts.clone())
    }

    /// The model of any combination: the primitive `uses[part]` of each part, under the couplings `alpha` [M x M]. Where no movement
    /// of the library is just this combination, there are no rows of its own from which its experts could be inferred again.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives, the couplings do not fit, or a covariance cannot be factorised.
    pub fn combination(&self, uses: &[usize], alpha: &DMatrix<f64>) -> Result<Vcgpdm, CombinationError> {
        self.check_uses(uses)?;
        check_couplings(alpha, self.part_count())?;
        let own = self.recorded(uses).map(|index| &self.movements[index]);
        self.model(uses, alpha, own, self.starts(uses))
    }

    /// The movement of just these primitives that they learned from, if there is one.
    pub fn recorded(&self, uses: &[usize]) -> Option<usize> {
        self.movements.iter().position(|movement| movement.uses == uses && movement.sums.is_some())
    }

    /// Checks that `uses` gives each part one of its primitives.
    ///
    /// # Errors
    ///
    /// When it does not.
    pub fn check_uses(&self, uses: &[usize]) -> Result<(), CombinationError> {
        let expected = self.part_count();
        if uses.len() != expected {
            return Err(CombinationError::Count { expected, found: uses.len() });
        }
        let wrong = uses
            .iter()
            .enumerate()
            .find(|(part, used)| self.primitives.get(**used).is_none_or(|primitive| primitive.part != *part));
        match wrong {
            Some((part, found)) => Err(CombinationError::Primitive { part, found: *found }),
            None => Ok(()),
        }
    }

    fn model(
        &self,
        uses: &[usize],
        alpha: &DMatrix<f64>,
        own: Option<&LearnedMovement>,
        starts: Vec<Vec<DMatrix<f64>>>,
    ) -> Result<Vcgpdm, CombinationError> {
        let m = self.part_count();
        let own = own.filter(|movement| movement.sums.is_some());
        let fitted = |a: usize| self.primitives[a].experts.iter().map(|expert| expert.fitted.clone());
        let experts: Vec<Vec<FittedExpert>> = uses.iter().map(|a| fitted(*a).collect()).collect();
        let sums = match own.and_then(|movement| movement.sums.clone()) {
            Some(sums) => sums,
            None => (0..m).map(|i| self.no_rows(uses, i)).collect(),
        };
        let mut model = Vcgpdm {
            order: self.order,
            jitter: self.jitter,
            parts: self.parts.clone(),
            experts,
            dynamics_covariance: Vec::with_capacity(m),
            sums,
            elsewhere: Vec::new(),
            alpha: alpha.clone(),
            starts,
            terms: self.terms.clone(),
        };
        let others = self.movements.iter().any(|other| other.sums.is_some() && !is_same(other, own));
        if others || self.primitives.iter().any(|p| p.experts.iter().any(|e| e.elsewhere.is_some())) {
            for i in 0..m {
                let Known { precision, b } = self.known(i, uses, own)?;
                model.elsewhere.push(Elsewhere { precision, b });
            }
        }
        for i in 0..m {
            let (noise, weights) = coupling_weights(alpha.column(i).as_slice());
            let k = stacked_covariance(model.experts.iter().map(|row| &row[i]));
            let inferred = model.infer(i, noise, &weights)?;
            model.dynamics_covariance.push(symmetric(&k * inferred.factor.solve(&k)));
        }
        Ok(model)
    }

    fn no_rows(&self, uses: &[usize], i: usize) -> DynamicsSums {
        let points = uses.iter().map(|a| self.primitives[*a].experts[i].fitted.z().nrows()).sum();
        DynamicsSums::zeros(points, self.parts[i].r().ncols())
    }

    /// The inducing outputs of the experts about part `i` in a combination, as they are kept while its couplings are learned.
    pub(super) fn kept(&self, i: usize, uses: &[usize]) -> Result<StoredOutputs, NumericsError> {
        let Known { precision, b } = self.known(i, uses, None)?;
        let k = stacked_covariance(uses.iter().map(|a| &self.primitives[*a].experts[i].fitted));
        let a = &k + precision;
        let coefficients =
            Factor::new(&a, "covariance of the data at the dynamics inducing points")?.solve(&b);
        StoredOutputs::new(&k, &a, coefficients)
    }

    /// What all rows but those of `except` say about the experts about part `i` of a combination. The other primitives are integrated
    /// out: what rows say about two experts together, they say of each with the uncertainty of the other.
    fn known(
        &self,
        i: usize,
        uses: &[usize],
        except: Option<&LearnedMovement>,
    ) -> Result<Known, NumericsError> {
        let all = self.gathered(i, except);
        let offsets = self.offsets(i);
        let rows_of = |a: &usize| offsets[*a]..offsets[*a + 1];
        let used: Vec<usize> = uses.iter().flat_map(rows_of).collect();
        let rest: Vec<usize> = (0..self.primitives.len()).filter(|a| !uses.contains(a)).collect();
        let rest: Vec<usize> = rest.iter().flat_map(rows_of).collect();
        let precision = pick(&all.precision, &used, &used);
        let b = all.b.select_rows(&used);
        let between = pick(&all.precision, &used, &rest);
        if between.iter().all(|v| *v == 0.0) {
            return Ok(Known { precision, b });
        }
        let k = stacked_covariance(self.primitives.iter().map(|primitive| &primitive.experts[i].fitted));
        let inner = pick(&(k + &all.precision), &rest, &rest);
        let factor = Factor::new(&inner, "covariance of the data at the dynamics inducing points")?;
        let of_rest = all.b.select_rows(&rest);
        Ok(Known {
            precision: symmetric(precision - &between * factor.solve(&between.transpose())),
            b: b - between * factor.solve(&of_rest),
        })
    }

    /// A - K and b / n of all primitives' experts about part `i`, stacked, from all rows but those of `except`.
    fn gathered(&self, i: usize, except: Option<&LearnedMovement>) -> Known {
        let offsets = self.offsets(i);
        let height = offsets[offsets.len() - 1];
        let latent = self.parts[i].r().ncols();
        let mut all = Known { precision: DMatrix::zeros(height, height), b: DMatrix::zeros(height, latent) };
        for (primitive, at) in self.primitives.iter().zip(&offsets) {
            if let Some(elsewhere) = &primitive.experts[i].elsewhere {
                let mut block = all.precision.view_mut((*at, *at), elsewhere.precision.shape());
                block += &elsewhere.precision;
                let mut rows = all.b.rows_mut(*at, elsewhere.b.nrows());
                rows += &elsewhere.b;
            }
        }
        for movement in self.movements.iter().filter(|movement| !is_same(movement, except)) {
            let Some(sums) = &movement.sums else { continue };
            let (noise, weights) = coupling_weights(movement.alpha.column(i).as_slice());
            let sizes = movement.uses.iter().map(|a| offsets[*a + 1] - offsets[*a]);
            let own = stack_offsets(sizes);
            let (psi2, b) = sums[i].weighted(&weights, &own);
            for (j, a) in movement.uses.iter().enumerate() {
                let size = own[j + 1] - own[j];
                for (k, other) in movement.uses.iter().enumerate() {
                    let shape = (size, own[k + 1] - own[k]);
                    let mut block = all.precision.view_mut((offsets[*a], offsets[*other]), shape);
                    block += psi2.view((own[j], own[k]), shape) / noise;
                }
                let mut rows = all.b.rows_mut(offsets[*a], size);
                rows += b.rows(own[j], size) / noise;
            }
        }
        all
    }
}

fn is_same(movement: &LearnedMovement, other: Option<&LearnedMovement>) -> bool {
    other.is_some_and(|other| std::ptr::eq(movement, other))
}

/// K of stacked experts, block by block.
fn stacked_covariance<'a>(experts: impl Iterator<Item = &'a FittedExpert> + Clone) -> DMatrix<f64> {
    let offsets = stack_offsets(experts.clone().map(|expert| expert.z().nrows()));
    let height = offsets[offsets.len() - 1];
    let mut k = DMatrix::zeros(height, height);
    for (expert, at) in experts.zip(&offsets) {
        k.view_mut((*at, *at), expert.k().shape()).copy_from(expert.k());
    }
    k
}

fn pick(m: &DMatrix<f64>, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
    m.select_rows(rows).select_columns(columns)
}
