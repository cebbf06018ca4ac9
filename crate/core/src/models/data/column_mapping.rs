//! Meaning of the columns of a model: the poses of a body, or the columns of tables.

use crate::motion::pose::PoseMapping;
use crate::motion::skeleton::MAX_POSITIONS;
use crate::series::Columns;
use std::fmt::Debug;

/// Meaning of the columns of a model.
pub trait ColumnMapping: Clone + Debug {
    /// The number of columns D.
    fn column_count(&self) -> usize;

    /// The name of a column.
    fn column_name(&self, column: usize) -> String;

    /// The unit of a column: predictions of the model are multiplied by it.
    fn unit(&self, column: usize) -> f64;

    /// The most frames of a rollout that can be shown, written and stored in memory.
    fn most_frames(&self) -> usize;

    /// The poses of a body; `None` for tables.
    fn poses(&self) -> Option<&PoseMapping> {
        None
    }
}

impl ColumnMapping for PoseMapping {
    fn column_count(&self) -> usize {
        PoseMapping::column_count(self)
    }

    fn column_name(&self, column: usize) -> String {
        let columns = self.columns();
        let name = |joint: usize| self.skeleton().joints.get(joint).map_or("", |joint| joint.name.as_str());
        columns.get(column).map_or_else(String::new, |at| format!("{}.{}", name(at.joint), at.kind.name()))
    }

    /// Angles and leg lengths have natural units.
    fn unit(&self, _column: usize) -> f64 {
        1.0
    }

    fn most_frames(&self) -> usize {
        self.skeleton().max_frames()
    }

    fn poses(&self) -> Option<&PoseMapping> {
        Some(self)
    }
}

impl ColumnMapping for Columns {
    fn column_count(&self) -> usize {
        self.names().len()
    }

    fn column_name(&self, column: usize) -> String {
        self.names().get(column).cloned().unwrap_or_default()
    }

    fn unit(&self, column: usize) -> f64 {
        self.units().get(column).copied().unwrap_or(1.0)
    }

    fn most_frames(&self) -> usize {
        MAX_POSITIONS / self.names().len().max(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rollout_of_many_columns_has_fewer_frames() {
        let most = |count: usize| Columns::new(vec!["x".to_owned(); count], vec![1.0; count]).most_frames();
        assert_eq!([most(0), most(1), most(4)], [MAX_POSITIONS, MAX_POSITIONS, MAX_POSITIONS / 4]);
    }
}
