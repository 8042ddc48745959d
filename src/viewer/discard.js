// Empties a group and frees what its objects hold on the GPU, but not what other objects use as well: geometries with
// `userData.is_shared`, and the attribute that is given.

export function discard(group, shared_attribute) {
  group.traverse(({ geometry, material }) => {
    material?.dispose();
    if (!geometry || geometry.userData.is_shared) return;
    for (const [name, attribute] of Object.entries(geometry.attributes))
      if (attribute === shared_attribute) geometry.deleteAttribute(name);
    geometry.dispose();
  });
  group.clear();
}
