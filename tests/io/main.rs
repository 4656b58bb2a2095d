//! Reading and writing files: round trips, malformed and damaged files, real models.

mod crusts;
mod damage;
mod malformed;
mod models;
mod round_trip;
mod samples;
mod saving;
mod tables;
