/// Two growing discs in free flight: when they touch, and what a touch does.
#pragma once

namespace crawford {

/// Motion of a second disc as a first one sees it. Units are the caller's; they cancel.
struct Approach {
    double x, y;    ///< from the first centre to the second
    double u, v;    ///< velocity of the second less that of the first
    double reach;   ///< sum of the radii
    double growth;  ///< its rate of change
};

/// The time from now until |(x, y) + t (u, v)| = reach + t growth with the discs closing in;
/// infinity where they never do. Discs that overlap by round-off touch now if they close in.
double time_to_contact(const Approach&);

/// The impulse along the line of centres with which discs in contact rebound: elastic in the frame
/// of their moving rims, so that the normal velocity w becomes 2 growth - w. It is added to the
/// second disc's momentum and taken from the first's.
double impulse(const Approach&, double mass, double other_mass);

}  // namespace crawford
