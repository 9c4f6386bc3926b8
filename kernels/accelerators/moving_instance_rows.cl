// Template: rows of rays in the space of a group, of instances some of which move: each ray sees them at its own time. Included by
// packet_instance_leaf.cl.

FUNCTION void transform_each(Scene scene, uint instance, const ray_x16 *world, uint lanes, Row *row) {
    row->origin = world->origin, row->direction = world->direction;
    for (; lanes != 0u; lanes &= lanes - 1u) {
        const uint lane = lowest_bit(lanes);
#define COMPONENT(column) (((float *)&row->column)[lane])
        Ray ray;
        ray.origin = make3(COMPONENT(origin.x), COMPONENT(origin.y), COMPONENT(origin.z));
        ray.direction = make3(COMPONENT(direction.x), COMPONENT(direction.y), COMPONENT(direction.z));
        const Ray inner = ray_in_group(scene, PLACEMENT(instance, LANE_TIME(*world, lane)), ray);
        COMPONENT(origin.x) = inner.origin.x, COMPONENT(origin.y) = inner.origin.y, COMPONENT(origin.z) = inner.origin.z;
        COMPONENT(direction.x) = inner.direction.x, COMPONENT(direction.y) = inner.direction.y, COMPONENT(direction.z) = inner.direction.z;
#undef COMPONENT
    }
}

/// Origins and directions of the row, as far as lanes enter.
FUNCTION void transform_row(Scene scene, uint instance, const ray_x16 *world, int16 enters, Row *row) {
    const Placement place = PLACEMENT(instance, 0.0f);
    if (instance_record(scene, place)->parts != 0u) {
        transform_each(scene, instance, world, mask_bits(enters), row);
        return;
    }
    const Transform m = transforms_of(scene, place).to_group;
    row->origin = transformed_point(m, world->origin), row->direction = transformed_direction(m, world->direction);
}
