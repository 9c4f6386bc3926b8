// Template, included once per level: LEVEL(name) names its functions, the LEAF_ macros test one block.
// No acceleration structure: every block of primitives is tested. The reference for the others.

#define FOR_EACH_BLOCK(KIND, Record, name) \
    for (uint block = 0u; block < scene.header->blocks[KIND].count; ++block) TEST(KIND, block);

static Hit LEVEL(closest_hit)(Scene scene, Ray ray) {
    ray_x8 lanes = prepare(ray, scene.header->extent);
    Hit hit = {ray.t_max, 0.0f, 0.0f, NO_HIT};
#define TEST(kind, block) LEAF_CLOSEST_HIT(scene, kind, block, &lanes, &hit)
    FOR_EACH_PRIMITIVE(FOR_EACH_BLOCK)
#undef TEST
    return hit;
}

static bool LEVEL(occluded)(Scene scene, Ray ray) {
    const ray_x8 lanes = prepare(ray, scene.header->extent);
#define TEST(kind, block) \
    if (LEAF_OCCLUDES(scene, kind, block, &lanes)) return true
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
