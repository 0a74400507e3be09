#pragma once

#include "core/model/integrators.h"
#include "core/model/scene.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace esm {

/// A step of a run, or several whole ones in a row.
struct TimeSpan {
    double start, end; ///< s
    std::size_t steps; ///< 1 where it is not whole
    bool isWhole;      ///< of the nominal length
    bool beginsAnew;   ///< what builds on earlier steps begins anew: a corner lies between them and its end
};

/// How finely a run's time is divided.
struct TimeDivision {
    double timeStep;  ///< s, nominal, above zero
    int halvings = 0; ///< every step, cut ones too, is taken in 2 to the power of this
    double stepLength() const { return std::ldexp(timeStep, -halvings); } ///< s, of a whole one
};

/// How a run's time is divided into steps: into whole ones that begin at multiples of the nominal step, cut
/// where a load begins, ends or turns (a corner), and at the end. Between two corners every load is then
/// smooth, which integrators of higher order count on, and no load is shorter than a step.
///
/// A step of another length asks integrators that solve for another factorisation. They therefore cut only
/// the steps that take few lengths on the whole; in the others the loads' mean stands in.
///
/// Halving keeps the cuts where they are and halves what lies between: errors then fall evenly, also those of
/// cut steps, and what halving changes tells how much is left.
class Timeline {
public:
    Timeline(const Scene& scene, const TimeDivision& division, Integrator integrator, std::size_t nodeCount);

    double time() const { return m_time; } ///< s, that was reached
    bool isAtEnd() const { return m_time >= m_duration; }
    /// Whether a time, s, has come; what rounding misses it by is none.
    bool hasReached(double time) const { return m_time >= time - m_close; }

    /// The next step; where whole ones follow each other without a corner, up to `most` of them that begin
    /// before `until`, s. Precondition: not at the end.
    TimeSpan next(double until, std::size_t most) const;
    /// Goes on to where that ends, or to fewer of its whole steps.
    void advance(const TimeSpan& span, std::size_t steps);

    /// Corners inside steps that are not cut there.
    std::size_t averagedCorners() const { return m_averaged; }

private:
    /// A part of a cut step; taken in as many steps as a whole one, where it is long enough.
    struct Piece {
        double begin, end; ///< s
        double parts;      ///< steps in it
        double step = 0;   ///< the number of the next one
    };

    void enter();
    Piece pieceUntil(double end) const;
    bool meetsCorner(double end) const;
    double wholeTime(double step) const { return step * m_step; }

    double m_nominal, m_step, m_duration; ///< s
    double m_parts;                       ///< steps in a nominal one
    double m_close;                       ///< s, apart that times are no more to be the same
    std::vector<double> m_corners;        ///< s, at which steps are cut, rising; the last is the end
    std::vector<double> m_all;            ///< s, corners whether or not they are cut at, rising
    double m_last = 0;                    ///< s, length of the last step
    std::size_t m_averaged = 0;
    std::size_t m_next = 0;       ///< the first corner ahead
    double m_time = 0;            ///< s
    double m_taken = 0;           ///< whole steps up to the last nominal one's beginning, or beyond
    double m_whole = 0;           ///< whole ones from here to the next corner
    std::optional<Piece> m_piece; ///< of the cut step that we are in
};

/// Times inside the scene at which the organ is split, s, rising.
std::vector<double> splitCorners(const Scene& scene);
/// Times inside the scene at which a force begins or ends, and at which a led node or an instrument changes
/// its velocity or its turning, or a pressure the way it rises, s, rising.
std::vector<double> forceCorners(const Scene& scene);
std::vector<double> pathCorners(const Scene& scene);

} // namespace esm
