// Template, included once per level: LEVEL(name) names its functions, LEVEL_KINDS(X) lists its kinds, the LEAF_ macros test one block.
// No acceleration structure, for packets: every block of primitives is tested.

#define FOR_EACH_BLOCK(KIND, Record, name) \
    for (uint block = 0u; block < group->blocks[KIND].count; ++block) TEST(KIND, block);

static void LEVEL(closest_hits)(Scene scene, const global Group *group, PacketRays *packet, PacketHits *hits) {
#define TEST(kind, block) LEAF_CLOSEST_HITS(scene, group, kind, block, ALL_ROWS, packet, hits)
    LEVEL_KINDS(FOR_EACH_BLOCK)
#undef TEST
}

static void LEVEL(end_occluded)(Scene scene, const global Group *group, PacketRays *packet) {
#define TEST(kind, block) LEAF_ENDS_RAYS(scene, group, kind, block, ALL_ROWS, packet)
    LEVEL_KINDS(FOR_EACH_BLOCK)
#undef TEST
}
#undef FOR_EACH_BLOCK
