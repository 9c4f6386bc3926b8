// Stands for core/time.cl in scenes where nothing moves: rays have no time.
#pragma once

#define TIME_OF_RAY
#define TIME_OF_ROW
#define TIME_OF_HITS
#define SET_TIME(thing, value) ((void)0)
#define SET_LANE_TIME(row, lane, value) ((void)0)
