// The time of rays, for tracing in scenes where something moves: what of its structures is there for that.
#pragma once

#define TIME_OF_RAY real time;
#define TIME_OF_ROW float16 time;
#define TIME_OF_HITS float time;
#define SET_TIME(thing, value) (thing).time = (value)
/// Of one of a row.
#define LANE_TIME(row, lane) (((const float *)&(row).time)[lane])
#define SET_LANE_TIME(row, lane, value) ((float *)&(row).time)[lane] = (value)
