package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.geometry.Shape;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ImportDraft;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import java.util.Optional;

/**
 * Area lights: shapes that glow. They shine from the side of their normal; ours shine from both sides, unless they are solids, where the other side is
 * never seen, or parallelograms.
 */
final class GlowingShapes {
    private final Spectra spectra;
    private final ImportDraft draft;

    GlowingShapes(Spectra spectra, ImportDraft draft) {
        this.spectra = spectra;
        this.draft = draft;
    }

    /** Adds a shape with the light that it is. */
    void add(ShapeDefinition shape, Form form, Affine map, Shape placed, Surface surface) {
        Parameters light = shape.areaLight();
        boolean isTwoSided = light.isTrue("twosided", false);
        Rgb radiance = radiance(shape, form, map, isTwoSided);
        if (radiance.max() == 0) {
            draft.object("", placed, reflecting(surface));
            return;
        }
        String place = shape.parameters().place().shown();
        if (!isTwoSided && !shinesOutwards(form, shape.isReversed())) {
            Optional<Light> pane = parallelogram(form, map, shape.isReversed(), radiance);
            if (pane.isPresent()) {
                if (!isBlack(surface)) {
                    draft.notes().add(place, "a lamp that shines from one side reflects nothing");
                }
                draft.light(pane.get());
                return;
            }
            draft.notes().add(place, "a lamp that is no solid and no parallelogram shines from both sides");
        }
        draft.object("", placed, glowing(surface, radiance, place));
    }

    private Rgb radiance(ShapeDefinition shape, Form form, Affine map, boolean isTwoSided) {
        Parameters p = shape.areaLight();
        if (p.has("filename")) {
            draft.notes().add(p.place().shown(), "an image on a lamp is left out: it shines evenly");
        }
        Rgb color = spectra.rgb(p, "L", Spectra.Kind.LIGHT, shape.areaLightSpace(), Rgb.WHITE);
        double scale = Math.max(0, p.number("scale", 1));
        double power = p.number("power", -1);
        if (power > 0) {
            scale *= power / (StrictMath.PI * area(form, map) * (isTwoSided ? 2 : 1));
        }
        return color.times(Rgb.gray(scale));
    }

    private static Material reflecting(Surface surface) {
        return surface.isInterface() ? Material.Matte.of(Texture.of(Rgb.BLACK)) : surface.material();
    }

    private static boolean isBlack(Surface surface) {
        return surface.isInterface()
                || surface.material() instanceof Material.Matte m
                        && m.color() instanceof Texture.Solid s
                        && s.color().linear().max() == 0;
    }

    private Material glowing(Surface surface, Rgb radiance, String place) {
        Material m = surface.isInterface() ? Material.Matte.of(Texture.of(Rgb.BLACK)) : surface.material();
        if (m instanceof Material.Matte matte) {
            return matte.withRadiance(radiance);
        } else if (m instanceof Material.Glossy g) {
            return new Material.Glossy(g.color(), g.roughness(), g.conductor(), g.multipleScattering(), radiance, 0);
        } else if (m instanceof Material.Coated c) {
            return new Material.Coated(
                    c.color(), c.roughness(), c.indexOfRefraction(), c.nonlinear(), radiance, c.ultraviolet());
        }
        draft.notes().add(place, "a lamp whose material is " + m.type() + " reflects nothing and has no holes");
        return Material.Matte.of(Texture.of(Rgb.BLACK)).withRadiance(radiance);
    }

    /** Whether the side that does not shine is never seen: inside of a solid. */
    private static boolean shinesOutwards(Form form, boolean isReversed) {
        if (form instanceof Form.Ball) {
            return !isReversed;
        }
        return form instanceof Form.Triangles t && t.mesh().isClosed() && isOutwards(t.mesh()) != isReversed;
    }

    /** Whether the triangles of a closed mesh wind counterclockwise as seen from outside, by the sign of its volume. */
    private static boolean isOutwards(TriangleMesh mesh) {
        Vec3 middle = mesh.min().plus(mesh.max()).times(0.5);
        double sum = 0;
        for (int t = 0; t < mesh.triangles(); t++) {
            sum += mesh.areaNormal(t).dot(mesh.position(mesh.vertex(t, 0)).minus(middle));
        }
        return sum > 0;
    }

    private static double area(Form form, Affine map) {
        TriangleMesh mesh = PlacedForms.triangles(form);
        double sum = 0;
        for (int t = 0; t < mesh.triangles(); t++) {
            Vec3 a = map.vector(mesh.position(mesh.vertex(t, 0)));
            Vec3 b = map.vector(mesh.position(mesh.vertex(t, 1))).minus(a);
            Vec3 c = map.vector(mesh.position(mesh.vertex(t, 2))).minus(a);
            sum += b.cross(c).length() / 2;
        }
        return sum;
    }

    /** The light of two triangles that are a parallelogram. */
    private static Optional<Light> parallelogram(Form form, Affine map, boolean isReversed, Rgb radiance) {
        if (!(form instanceof Form.Triangles t) || t.mesh().triangles() != 2) {
            return Optional.empty();
        }
        TriangleMesh mesh = t.mesh();
        for (int k = 0; k < 3; k++) {
            for (int j = 0; j < 3; j++) {
                // The edge from corner k + 1 to k + 2 of the first triangle runs the other way in the second one.
                Vec3 b = corner(mesh, 0, k + 1);
                Vec3 d = corner(mesh, 0, k + 2);
                if (b.equals(corner(mesh, 1, j + 2)) && d.equals(corner(mesh, 1, j + 1))) {
                    return pane(
                            corner(mesh, 0, k),
                            b,
                            corner(mesh, 1, j),
                            d,
                            map,
                            facesBack(mesh, map, isReversed),
                            radiance);
                }
            }
        }
        return Optional.empty();
    }

    private static Vec3 corner(TriangleMesh mesh, int triangle, int k) {
        return mesh.position(mesh.vertex(triangle, k % 3));
    }

    /** Whether it shines to the side from which its triangles wind clockwise once they are in the world. */
    private static boolean facesBack(TriangleMesh mesh, Affine map, boolean isReversed) {
        boolean isBack = isReversed != map.determinant() < 0;
        return mesh.hasNormals() ? isBack != mesh.areaNormal(0).dot(mesh.normal(mesh.vertex(0, 0))) < 0 : isBack;
    }

    private static Optional<Light> pane(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Affine map, boolean isBack, Rgb radiance) {
        ExactPoint first = Affine.exact(map.point(a));
        ExactPoint second = Affine.exact(map.point(isBack ? d : b));
        ExactPoint third = Affine.exact(map.point(c));
        ExactPoint fourth = Affine.exact(map.point(isBack ? b : d));
        try {
            return Optional.of(
                    new Light.Rectangle(first, second, third, fourth, Rgb.WHITE, false, Emission.radiance(radiance)));
        } catch (InvalidValueException e) {
            return Optional.empty();
        }
    }
}
