package enlightenment.importer.mitsuba;

import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.Fronts;
import enlightenment.importer.support.GlowingMaterial;
import enlightenment.importer.support.PlacedShapes;
import enlightenment.importer.support.UvMap;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import java.io.IOException;
import java.util.Optional;

/**
 * Adds shapes with area emitters, which emit to the side of their shading normals. Measured with Mitsuba 3.9: these are the normals of a mesh's
 * file where it has some, mapped as normals are, else those by which its triangles wind once they are placed; those of rectangles and disks are mapped as
 * normals are; those of cubes and cylinders point outwards under all maps, those of spheres inwards under one that mirrors. {@code flip_normals} turns all.
 */
final class LampShapes {
    private final SceneIndex scene;
    private final MeshShapes meshes;
    private final PlacedShapes placed;

    LampShapes(SceneIndex scene, MeshShapes meshes, PlacedShapes placed) {
        this.scene = scene;
        this.meshes = meshes;
        this.placed = placed;
    }

    /** A surface that emits besides. */
    Surface glowing(XmlElement e, Surface surface, AreaEmission emission) {
        Material.EmissionPattern pattern = Material.EmissionPattern.of(emission.texture());
        UvMap uv = emission.texture().isPresent() ? emission.uv() : surface.map();
        Material plain = surface.material().orElse(null);
        Optional<Material> both =
                plain == null ? Optional.empty() : GlowingMaterial.of(plain, emission.radiance(), pattern);
        if (plain != null && both.isEmpty()) {
            scene.note(e, "what emits is " + plain.type() + " besides, which is left out");
        }
        Material m = both.orElseGet(() -> GlowingMaterial.black(emission.radiance(), pattern));
        return new Surface(Optional.of(m), uv, false);
    }

    /**
     * Adds what an element has become.
     *
     * @param map from the element's coordinates to those of the scene
     * @param surface one that glows
     */
    void add(Properties p, Iterable<Shape> shapes, Affine map, Surface surface) throws IOException {
        XmlElement e = p.element();
        boolean isFlipped = p.flag("flip_normals", false);
        Material m = surface.material().orElseThrow();
        boolean isPlain = GlowingMaterial.isBlack(m) && m.radianceMap().isEmpty();
        for (Shape shape : shapes) {
            boolean isTurned = isFlipped != isTurned(p, shape, map);
            Optional<Rectangle> flat = isPlain ? flat(shape, map) : Optional.empty();
            if (flat.isPresent()) {
                Vec3 normal = Fronts.normal(shape);
                scene.draft()
                        .light(PlacedShapes.oneSided(flat.get(), isTurned ? normal.negated() : normal, m.radiance()));
            } else {
                addObject(e, shape, isTurned, surface);
            }
        }
    }

    private void addObject(XmlElement e, Shape shape, boolean isTurned, Surface surface) {
        Material m = surface.material().orElseThrow();
        boolean isInwards = isTurned && !Fronts.isTurnable(shape);
        Shape facing = shape;
        if (isTurned && !isInwards) {
            boolean isMapped = shape instanceof Rectangle && surface.isTextured();
            facing = Fronts.turned(
                    isMapped ? Mesh.of(TexturedRectangle.mesh((Rectangle) shape, UvMap.IDENTITY)) : shape);
        }
        Material.EmissionPattern.Side side =
                isInwards ? Material.EmissionPattern.Side.BACK : Material.EmissionPattern.Side.FRONT;
        scene.draft().object(e.attribute("id"), facing, GlowingMaterial.withSide(m, side));
    }

    /** Whether the front of a shape is not the side to which it emits without {@code flip_normals}. */
    private boolean isTurned(Properties p, Shape shape, Affine map) throws IOException {
        boolean isMirrored = map.determinant() < 0;
        switch (p.element().type()) {
            case "obj", "ply", "serialized":
                return meshes.isTurned(p, (Mesh) shape, isMirrored);
            case "rectangle", "disk":
                Vec3 mapped = map.column(0).cross(map.column(1));
                return Fronts.normal(shape).dot(isMirrored ? mapped.negated() : mapped) < 0;
            case "sphere":
                return isMirrored != isInwards(shape, map.point(p.point("center", Vec3.ZERO)));
            case "cylinder":
                Vec3 ends = p.point("p0", Vec3.ZERO).plus(p.point("p1", Vec3.Z));
                return isInwards(shape, map.point(ends.times(0.5)));
            default:
                return isInwards(shape, map.offset());
        }
    }

    /** Whether the front of a part of a convex surface is its inside. */
    private static boolean isInwards(Shape shape, Vec3 middle) {
        return Fronts.isTurnable(shape)
                && Fronts.normal(shape).dot(Fronts.point(shape).minus(middle)) < 0;
    }

    private Optional<Rectangle> flat(Shape shape, Affine map) {
        if (shape instanceof Rectangle r) {
            return Optional.of(r);
        }
        return shape instanceof Mesh m && m.origin().isPresent()
                ? MeshShapes.parallelogram(m.triangles()).map(q -> placed.rectangle(map.after(q)))
                : Optional.empty();
    }
}
