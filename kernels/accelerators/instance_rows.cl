// Template: rows of rays in the space of a group, of instances at rest. Included by packet_instance_leaf.cl.

/// Origins and directions of the row.
FUNCTION void transform_row(Scene scene, uint instance, const ray_x16 *world, int16 enters, Row *row) {
    const Transform m = transforms_of(scene, instance).to_group;
    row->origin = transformed_point(m, world->origin), row->direction = transformed_direction(m, world->direction);
}
