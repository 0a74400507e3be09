#pragma once

#include <gtest/gtest.h>
#include <QTest>

/// ms; how long a test waits at most for what has to happen. Generous: the machine may be slow and busy.
constexpr int patience = 60000;

/// Waits for a condition while events are handled; a failed wait fails the test. Nothing else may be waited
/// for in a test: a fixed time is too long on an idle machine and too short on a busy one.
#define ESM_EVENTUALLY(condition)                                                                            \
    ASSERT_TRUE(QTest::qWaitFor([&] { return bool(condition); }, patience)) << #condition
