//! Plane figures, and GeoJSON.

mod brute;
mod drawing;
mod geojson;
mod malformed;
mod models;
mod normalised;
mod refusals;
mod validate;
mod writing;
