// Template, included once per level: LEVEL(name) names its functions, LEVEL_KINDS(X) lists its kinds, the LEAF_ macros test one block.
// No acceleration structure: every block of primitives is tested. The reference for the others.

#define FOR_EACH_BLOCK(KIND, Record, name) \
    for (uint block = 0u; block < group->blocks[KIND].count; ++block) TEST(KIND, block);

static void LEVEL(closest_hit)(Scene scene, const global Group *group, ray_x8 *ray, Nearest *nearest) {
#define TEST(kind, block) LEAF_CLOSEST_HIT(scene, group, kind, block, ray, nearest)
    LEVEL_KINDS(FOR_EACH_BLOCK)
#undef TEST
}

static bool LEVEL(any_hit)(Scene scene, const global Group *group, const ray_x8 *ray, HitList *list) {
#define TEST(kind, block) \
    if (LEAF_ANY_HIT(scene, group, kind, block, ray, list)) return true
    LEVEL_KINDS(FOR_EACH_BLOCK)
#undef TEST
    return false;
}
#undef FOR_EACH_BLOCK
