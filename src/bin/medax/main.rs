//! The program `medax`: every operation of the library from the command line.
//!
//! A command reads its input, calls the library, writes its outputs and fills in a [`Report`];
//! what to print, and the exit code, is decided here and in `report.rs`.

mod boundary;
mod cocone;
mod compare;
mod crust;
mod decimate;
mod extend;
mod field;
mod figure;
mod flatten;
mod flow;
mod info;
mod labels;
mod medial;
mod omit;
mod pair;
mod poles;
mod progress;
mod report;
mod sample;
mod session;
mod side;
mod sizes;
mod triangulate;
mod union;
mod variants;
mod winding;

use clap::Parser;
use report::Report;
use session::{Failure, Session};
use std::process::ExitCode;

/// Samples of a surface, meshes and plane figures in; triangulations, poles, power crusts, medial axes, cores and pair-meshes out.
#[derive(Parser)]
#[command(version, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    common: session::Options,
}

#[derive(clap::Subcommand)]
enum Command {
    Triangulate(triangulate::Options),
    Poles(poles::Options),
    Crust(Box<crust::Options>),
    Cocone(cocone::Options),
    Medial(Box<medial::Options>),
    Flow(Box<flow::Options>),
    Pair(pair::Options),
    Field(Box<field::Options>),
    Union(union::Options),
    Info(info::Options),
    Compare(compare::Options),
    Decimate(decimate::Options),
    Sample(sample::Options),
    Winding(winding::Options),
}

impl Command {
    fn run(&self, session: &mut Session) -> Result<Report, Failure> {
        match self {
            Command::Triangulate(options) => triangulate::run(options, session),
            Command::Poles(options) => poles::run(options, session),
            Command::Crust(options) => crust::run(options, session),
            Command::Cocone(options) => cocone::run(options, session),
            Command::Medial(options) => medial::run(options, session),
            Command::Flow(options) => flow::run(options, session),
            Command::Pair(options) => pair::run(options, session),
            Command::Field(options) => field::run(options, session),
            Command::Union(options) => union::run(options, session),
            Command::Info(options) => info::run(options, session),
            Command::Compare(options) => compare::run(options, session),
            Command::Decimate(options) => decimate::run(options, session),
            Command::Sample(options) => sample::run(options, session),
            Command::Winding(options) => winding::run(options, session),
        }
    }
}

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return report::refuse(&error),
    };
    let common = &arguments.common;
    let mut session = Session::new(common);
    let result = arguments.command.run(&mut session);
    session.finish();
    match result {
        Ok(report) => report.print(&session, common.json, common.quiet),
        Err(failure) => failure.of_sample(&session).print(common.json),
    }
}
