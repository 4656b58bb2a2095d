//! Where labels of cells come from.

use crate::report::Report;
use crate::session::{Failure, Session};
use medax::{Cocone, Dual, Labels, PowerCrust, Status};
use serde_json::{Map, json};
use std::path::PathBuf;
use std::sync::Arc;

/// What tells inside from outside.
#[derive(clap::Args)]
pub struct LabelArguments {
    /// What tells inside from outside: the watertight surface of Tight Cocone, by default, or the power crust
    #[arg(long, value_enum, value_name = "SOURCE", conflicts_with = "label_mesh")]
    labels: Option<Source>,
    /// Let this mesh tell instead, which may be the input itself; its faces must point out of the solid
    #[arg(long, value_name = "MESH")]
    label_mesh: Option<PathBuf>,
    /// Say in how many cells the other sources disagree
    #[arg(long)]
    compare_labels: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Source {
    Cocone,
    Crust,
}

impl Source {
    const ALL: [Source; 2] = [Source::Cocone, Source::Crust];

    fn name(self) -> &'static str {
        match self {
            Source::Cocone => "cocone",
            Source::Crust => "crust",
        }
    }

    fn labels(self, dual: &Arc<Dual>, session: &mut Session) -> Result<Labels, Failure> {
        match self {
            Source::Cocone => {
                let cocone = Cocone::new(dual, Default::default(), &session.job)?;
                Ok(Labels::of_cocone(&cocone, &session.job)?)
            }
            Source::Crust => {
                let points = dual.triangulation().points();
                let crust = PowerCrust::build(points, Default::default(), &session.job)?;
                Ok(Labels::of_crust(dual, &crust, &session.job)?)
            }
        }
    }
}

impl LabelArguments {
    /// Whether one of the options is given.
    pub fn are_asked_for(&self) -> bool {
        self.labels.is_some() || self.label_mesh.is_some() || self.compare_labels
    }

    /// Says what the options are where no labels are made.
    pub fn without(report: &mut Report) {
        for name in ["labels", "label_mesh"] {
            report.parameters.insert(name.into(), json!(null));
        }
        report.parameters.insert("compare_labels".into(), json!(false));
    }

    /// The labels, and what there is to say of them.
    pub fn labels(
        &self,
        dual: &Arc<Dual>,
        report: &mut Report,
        session: &mut Session,
    ) -> Result<Labels, Failure> {
        let (name, labels) = match &self.label_mesh {
            Some(path) => {
                let mesh = session.read_complex(path)?;
                let labels = Labels::of_mesh(dual, &mesh, &session.job);
                ("mesh", labels.map_err(Failure::about(path))?)
            }
            None => {
                let source = self.labels.unwrap_or(Source::Cocone);
                (source.name(), source.labels(dual, session)?)
            }
        };
        report.parameters.insert("labels".into(), json!(name));
        let path = self.label_mesh.as_ref().map(|path| path.to_string_lossy());
        report.parameters.insert("label_mesh".into(), json!(path));
        report.parameters.insert("compare_labels".into(), json!(self.compare_labels));
        let inner = labels.inner_count();
        let outer = labels.is_inner().len() - inner;
        let mut differ = Map::new();
        if self.compare_labels {
            for source in Source::ALL.into_iter().filter(|source| source.name() != name) {
                let other = source.labels(dual, session);
                let disagreement = match other {
                    Ok(other) => Some(labels.disagreement(&other)?),
                    Err(failure) if failure.error.status() == Status::Cancelled => {
                        return Err(failure);
                    }
                    // The labels asked for are there all the same.
                    Err(failure) => {
                        let (name, message) = (source.name(), failure.error.message());
                        session
                            .warn(&format!("there are no labels of {name} to compare: {message}"));
                        None
                    }
                };
                differ.insert(source.name().into(), json!(disagreement));
            }
        }
        for (other, count) in differ.iter().filter(|(_, count)| !count.is_null()) {
            report
                .lines
                .push(("disagreement", format!("{count} cells with the labels of {other}")));
        }
        report.more.insert(
            "labels".into(),
            json!({ "inner": inner, "outer": outer, "disagreement": differ }),
        );
        report.lines.push(("labels", format!("{inner} inner, {outer} outer cells, by {name}")));
        if inner == 0 {
            session.warn("no cell is inner: the sample is too sparse for its shape");
        }
        Ok(labels)
    }
}
