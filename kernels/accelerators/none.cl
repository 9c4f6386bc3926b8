// Template, included once per level: LEVEL(name) names its functions, the LEAF_ macros test one block.
// No acceleration structure: every block of primitives is tested. The reference for the others.

#define FOR_EACH_BLOCK(KIND, Record, name) \
    for (uint block = 0u; block < scene.header->blocks[KIND].count; ++block) TEST(KIND, block);

static Nearest LEVEL(closest_hit)(Scene scene, Ray ray) {
    ray_x8 lanes = prepare(ray, scene.header->extent);
    Nearest nearest = nothing_hit(&lanes);
#define TEST(kind, block) LEAF_CLOSEST_HIT(scene, kind, block, &lanes, &nearest)
    FOR_EACH_PRIMITIVE(FOR_EACH_BLOCK)
#undef TEST
    return nearest;
}

static bool LEVEL(any_hit)(Scene scene, Ray ray, HitList *list) {
    const ray_x8 lanes = prepare(ray, scene.header->extent);
#define TEST(kind, block) \
    if (LEAF_ANY_HIT(scene, kind, block, &lanes, list)) return true
    FOR_EACH_PRIMITIVE(FOR_EACH_BLOCK)
#undef TEST
    return false;
}

static void LEVEL(closest_hits)(Scene scene, PacketRays *packet, PacketHits *hits) {
#define TEST(kind, block) LEAF_CLOSEST_HITS(scene, kind, block, packet, hits)
    FOR_EACH_PRIMITIVE(FOR_EACH_BLOCK)
#undef TEST
}

static void LEVEL(end_occluded)(Scene scene, PacketRays *packet) {
#define TEST(kind, block) LEAF_ENDS_RAYS(scene, kind, block, packet)
    FOR_EACH_PRIMITIVE(FOR_EACH_BLOCK)
#undef TEST
}
#undef FOR_EACH_BLOCK
