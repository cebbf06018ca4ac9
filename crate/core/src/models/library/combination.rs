//! From primitives to a model of any combination of them.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, block_diagonal, symmetric};
use crate::gp::stored_outputs::StoredOutputs;
use crate::gp::tall::product;
use crate::models::errors::CombinationError;
use crate::models::library::information::Information;
use crate::models::library::{LearnedMovement, Library};
use crate::models::rollout::couplings::{check_couplings, coupling_weights};
use crate::models::variational::{DynamicsSums, ExternalEvidence, FittedExpert, Vcgpdm};
use nalgebra::DMatrix;

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

    /// The model of any combination: the primitive `uses[part]` of each part, under the couplings `alpha` [M
    /// x M]. Only a combination that is a movement of the library has rows of its own, from which its experts
    /// can be inferred again.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives, the couplings do not fit, or a covariance cannot be
    /// factorised.
    pub fn combination(&self, uses: &[usize], alpha: &DMatrix<f64>) -> Result<Vcgpdm, CombinationError> {
        self.check_uses(uses)?;
        check_couplings(alpha, self.part_count())?;
        let own = self.recorded_movement(uses).map(|index| &self.movements[index]);
        self.model(uses, alpha, own, self.starts(uses))
    }

    /// The movement whose primitives are exactly these and learned from its rows; `None` where there is no
    /// such movement.
    pub fn recorded_movement(&self, uses: &[usize]) -> Option<usize> {
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
        for (part, primitive) in uses.iter().enumerate() {
            self.check_primitive(part, *primitive)?;
        }
        Ok(())
    }

    /// Checks that a primitive belongs to a part.
    ///
    /// # Errors
    ///
    /// When it does not.
    pub(super) fn check_primitive(&self, part: usize, primitive: usize) -> Result<(), CombinationError> {
        match self.primitives.get(primitive) {
            Some(found) if found.part == part => Ok(()),
            _ => Err(CombinationError::Primitive { part, found: primitive }),
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
            None => (0..m).map(|i| self.sums_of_no_rows(uses, i)).collect(),
        };
        let mut model = Vcgpdm {
            order: self.order,
            jitter: self.jitter,
            parts: self.parts.clone(),
            experts,
            dynamics_covariance: Vec::with_capacity(m),
            sums,
            external: Vec::new(),
            alpha: alpha.clone(),
            starts,
            terms: self.terms.clone(),
        };
        let others = self.movements.iter().any(|other| other.sums.is_some() && !is_same(other, own));
        if others || self.primitives.iter().any(|p| p.experts.iter().any(|e| e.external.is_some())) {
            for i in 0..m {
                let Information { precision, b } =
                    self.information(i, uses, &|movement| is_same(movement, own))?;
                model.external.push(ExternalEvidence { precision, b });
            }
        }
        for i in 0..m {
            let (noise, weights) = coupling_weights(alpha.column(i).as_slice());
            let k = block_diagonal(model.experts.iter().map(|row| row[i].k()));
            let inferred = model.infer(i, noise, &weights)?;
            model.dynamics_covariance.push(symmetric(product(&k, &inferred.factor.solve(&k))));
        }
        Ok(model)
    }

    fn sums_of_no_rows(&self, uses: &[usize], i: usize) -> DynamicsSums {
        let points = uses.iter().map(|a| self.primitives[*a].experts[i].fitted.z().nrows()).sum();
        DynamicsSums::zeros(points, self.parts[i].r().ncols())
    }

    /// The inducing outputs of the experts about part `i` of these primitives, as fixed outputs of a
    /// training.
    pub(super) fn fixed_dynamics_outputs(
        &self,
        i: usize,
        uses: &[usize],
    ) -> Result<StoredOutputs, NumericsError> {
        let Information { precision, b } = self.information(i, uses, &|_| false)?;
        let k = block_diagonal(uses.iter().map(|a| self.primitives[*a].experts[i].fitted.k()));
        let a = &k + precision;
        let coefficients =
            Factor::new(&a, "covariance of the data at the dynamics inducing points")?.solve(&b);
        StoredOutputs::new(&k, &a, coefficients)
    }

    /// The information about the experts about part `i` of the primitives `chosen`, from the rows of all
    /// movements that `is_left_out` does not leave out. The other primitives are integrated out.
    pub(super) fn information(
        &self,
        i: usize,
        chosen: &[usize],
        is_left_out: &dyn Fn(&LearnedMovement) -> bool,
    ) -> Result<Information, NumericsError> {
        let all = self.information_of_all(i, is_left_out);
        let offsets = self.offsets(i);
        let rows_of = |a: &usize| offsets[*a]..offsets[*a + 1];
        let others: Vec<usize> = (0..self.primitives.len()).filter(|a| !chosen.contains(a)).collect();
        let chosen: Vec<usize> = chosen.iter().flat_map(rows_of).collect();
        let others: Vec<usize> = others.iter().flat_map(rows_of).collect();
        let blocks = || self.primitives.iter().map(|primitive| primitive.experts[i].fitted.k());
        all.marginal(&chosen, &others, || block_diagonal(blocks()))
    }

    /// The information about the experts about part `i` of all primitives, stacked.
    pub(super) fn information_of_all(
        &self,
        i: usize,
        is_left_out: &dyn Fn(&LearnedMovement) -> bool,
    ) -> Information {
        let offsets = self.offsets(i);
        let mut all = Information::zeros(offsets[offsets.len() - 1], self.parts[i].r().ncols());
        for (primitive, at) in self.primitives.iter().zip(&offsets) {
            if let Some(external) = &primitive.experts[i].external {
                let mut block = all.precision.view_mut((*at, *at), external.precision.shape());
                block += &external.precision;
                let mut rows = all.b.rows_mut(*at, external.b.nrows());
                rows += &external.b;
            }
        }
        for movement in self.movements.iter().filter(|movement| !is_left_out(movement)) {
            if let Some(sums) = &movement.sums {
                let ranges: Vec<_> = movement.uses.iter().map(|a| offsets[*a]..offsets[*a + 1]).collect();
                all.add(&sums[i], movement.alpha.column(i).as_slice(), &ranges);
            }
        }
        all
    }
}

fn is_same(movement: &LearnedMovement, other: Option<&LearnedMovement>) -> bool {
    other.is_some_and(|other| std::ptr::eq(movement, other))
}
