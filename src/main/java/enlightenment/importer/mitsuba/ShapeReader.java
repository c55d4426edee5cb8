package enlightenment.importer.mitsuba;

import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.Fillings;
import enlightenment.importer.support.PlacedShapes;
import enlightenment.importer.support.UvMap;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** Reads shapes, with what they are made of and what they emit. */
final class ShapeReader {
    private static final int MOST_DEPTH = 16;

    /** Of all shapes, those of instances counted each time: groups of instances of groups multiply. */
    private static final int MOST_SHAPES = 1_000_000;

    private final SceneIndex scene;
    private final Affine world;
    private final BsdfReader bsdfs;
    private final EmissionReader emissions;
    private final MeshShapes meshes;
    private final PlacedShapes placed;
    private final LampShapes lamps;
    private final MediumReader media;
    private int count;

    /** @param world from the coordinates of the file to those of the scene */
    ShapeReader(SceneIndex scene, Affine world) {
        this.scene = scene;
        this.world = world;
        bsdfs = new BsdfReader(scene);
        emissions = new EmissionReader(scene);
        meshes = new MeshShapes(scene);
        placed = new PlacedShapes(scene.notes(), true);
        lamps = new LampShapes(scene, meshes, placed);
        media = new MediumReader(scene);
    }

    /** Adds a shape of the scene to it. */
    void add(XmlElement shape) throws IOException {
        add(shape, world, 0);
    }

    private void add(XmlElement e, Affine outer, int depth) throws IOException {
        if (depth > MOST_DEPTH) {
            throw e.failure("is an instance inside of itself");
        }
        if (++count > MOST_SHAPES) {
            throw e.failure("makes the scene have more than " + MOST_SHAPES + " shapes");
        }
        try {
            switch (e.type()) {
                case "shapegroup" -> {
                    // Only its instances are seen.
                }
                case "instance" -> addInstance(e, outer, depth);
                default -> addShape(e, outer);
            }
        } catch (InvalidValueException problem) {
            throw e.failure(e.described() + ": " + problem.getMessage());
        }
    }

    private void addInstance(XmlElement e, Affine outer, int depth) throws IOException {
        Properties p = new Properties(e);
        Affine map = outer.after(p.transform("to_world"));
        List<XmlElement> groups = scene.inside(e, "shape");
        if (groups.isEmpty()) {
            throw e.failure("must have a shapegroup inside, or a reference to one");
        }
        for (XmlElement group : groups) {
            for (XmlElement child : group.children()) {
                if (child.tag().equals("shape")) {
                    add(child, map, depth + 1);
                }
            }
        }
        scene.noteUnused(p);
    }

    private void addShape(XmlElement e, Affine outer) throws IOException {
        Properties p = new Properties(e);
        Affine map = outer.after(p.transform("to_world"));
        Surface surface =
                scene.inside(e, "bsdf").stream().findFirst().map(bsdfs::surface).orElse(BsdfReader.usual());
        Surface filled = filled(e, surface);
        p.ignore("id", "interior", "exterior");
        Optional<AreaEmission> emission = emissions.area(e, surface);
        if (filled.material().isEmpty() && emission.isEmpty()) {
            return;
        }
        p.ignore("flip_normals");
        if (emission.isPresent()) {
            if (!filled.equals(surface)) {
                scene.note(e, "a medium inside of a shape that emits is left out");
            }
            Surface glowing = lamps.glowing(e, surface, emission.get());
            lamps.add(p, shapes(p, map, glowing), map, glowing);
            scene.noteUnused(p);
        } else {
            List<Shape> shapes = shapes(p, map, filled);
            scene.noteUnused(p);
            for (Shape shape : shapes) {
                addSolid(p, shape, surface, filled);
            }
        }
    }

    /** The surface with the medium inside of a shape; the surface itself where that has no part in what is seen. */
    private Surface filled(XmlElement e, Surface surface) {
        boolean isOpen = surface.material().isEmpty() || surface.material().get() instanceof Glass;
        Optional<Medium.Coefficients> medium = isOpen ? media.interior(e) : Optional.empty();
        if (medium.isEmpty()) {
            return surface;
        }
        if (surface.isThin()) {
            scene.note(e, "what a thin dielectric around a medium reflects is left out");
        }
        if (surface.isThin() || surface.material().isEmpty()) {
            return new Surface(Optional.of(Material.Scattering.of(medium.get())), surface.map(), false);
        }
        Material solid = Fillings.filled((Glass) surface.material().get(), medium.get(), scene.notes(), e.place());
        return new Surface(Optional.of(solid), surface.map(), false);
    }

    /** Adds a shape with its filling, or without if it encloses no volume. */
    private void addSolid(Properties p, Shape shape, Surface surface, Surface filled) {
        Shape whole = whole(p, filled, shape);
        boolean isEmpty = !filled.equals(surface) && !whole.enclosesVolume();
        if (isEmpty) {
            scene.note(p.element(), "a medium in a shape that encloses no volume is left out");
        }
        Surface fit = isEmpty ? surface : filled;
        if (fit.material().isPresent()) {
            scene.draft().object(p.element().attribute("id"), whole, fitting(p, fit, whole));
        }
    }

    private List<Shape> shapes(Properties p, Affine map, Surface surface) throws IOException {
        String place = p.element().place();
        boolean isTextured = surface.isTextured();
        return switch (p.element().type()) {
            case "obj", "ply", "serialized" ->
                meshes.mesh(p, map, surface.map(), isTextured)
                        .map(m -> List.<Shape>of(m))
                        .orElse(List.of());
            case "rectangle" -> List.of(mapped(placed.rectangle(map), surface));
            case "sphere" -> {
                Vec3 c = p.point("center", new Vec3(0, 0, 0));
                double r = p.number("radius", 1);
                Affine ball = map.after(Affine.translate(c.x(), c.y(), c.z())).after(Affine.scale(r, r, r));
                yield List.of(mapped(placed.sphere(ball, isTextured, place), surface));
            }
            case "disk" -> List.of(mapped(placed.disk(map, isTextured, place), surface));
            case "cylinder" -> List.of(mapped(placed.cylinder(map.after(cylinder(p)), isTextured, place), surface));
            case "cube" ->
                PlacedShapes.cube(map, isTextured, surface.fillsSolid()).stream()
                        .map(s -> mapped(s, surface))
                        .toList();
            default -> {
                scene.note(p.element(), p.element().described() + " is left out: there is no such shape here");
                p.element().children().forEach(c -> p.ignore(c.name()));
                yield List.of();
            }
        };
    }

    /** From the cylinder about z from 0 to 1 to that between two points. */
    private static Affine cylinder(Properties p) {
        Vec3 p0 = p.point("p0", new Vec3(0, 0, 0));
        Vec3 axis = p.point("p1", new Vec3(0, 0, 1)).minus(p0);
        double r = p.number("radius", 1);
        if (axis.maxAbs() == 0 || !(r > 0)) {
            throw p.element().failure("needs two ends that differ, and a radius above 0");
        }
        Vec3 d = axis.normalized();
        Vec3 other = StrictMath.abs(d.x()) < StrictMath.abs(d.y()) ? Vec3.X : Vec3.Y;
        Vec3 a = axis.equals(new Vec3(0, 0, axis.z())) ? Vec3.X : other.cross(d).normalized();
        return Affine.ofColumns(a.times(r), d.cross(a).times(r), axis, p0);
    }

    /** Textures that are scaled or turned need a mesh, whose texture coordinates are changed. */
    private Shape mapped(Shape shape, Surface surface) {
        UvMap uv = surface.map();
        if (!surface.isTextured() || uv.equals(UvMap.IDENTITY)) {
            return shape;
        }
        if (shape instanceof Mesh m) {
            return new Mesh(uv.mapped(m.triangles(), false), Optional.empty(), m.transform());
        }
        return shape instanceof Rectangle r ? Mesh.of(TexturedRectangle.mesh(r, uv)) : shape;
    }

    /** The shape, without holes where a dielectric fills it. */
    private Shape whole(Properties p, Surface surface, Shape shape) {
        boolean isFilled = surface.fillsSolid() && !surface.isThin();
        return isFilled ? Fillings.whole(shape, scene.notes(), p.element().place()) : shape;
    }

    /** The material as it can stand on a shape. */
    private Material fitting(Properties p, Surface surface, Shape shape) {
        Material m = surface.material().orElseThrow();
        XmlElement e = p.element();
        if (m instanceof Glass glass) {
            boolean isSolid = shape.enclosesVolume();
            if (surface.isThin() && isSolid) {
                scene.note(e, "a thin dielectric around a volume becomes solid glass");
            } else if (!surface.isThin() && !isSolid) {
                scene.note(e, "a dielectric on a surface that encloses no volume becomes a thin pane");
            }
            return isSolid ? glass : glass.withRoughness(0);
        }
        return m;
    }
}
