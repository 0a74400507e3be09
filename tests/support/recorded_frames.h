#pragma once

#include "core/dynamics/measure/scene_run.h"

/// What a run hands out.
struct RecordedFrames {
    std::vector<double> times; ///< s
    std::vector<std::vector<Eigen::Vector3d>> positions;

    esm::FrameSink sink() {
        return [this](double time, const std::vector<Eigen::Vector3d>& now) {
            times.push_back(time);
            positions.push_back(now);
        };
    }
};
