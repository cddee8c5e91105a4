//! Lines of sight that meet no body: the road, the house fronts and the sky.

pub(super) mod backdrop;
mod contact;
mod house_fronts;
