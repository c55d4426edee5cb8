package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.Fronts;
import enlightenment.importer.support.GlowingMaterial;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.UvMap;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;

/** Area lights: shapes that glow from the side of their normal, or from both. */
final class GlowingShapes {
    private final Spectra spectra;
    private final ImportDraft draft;
    private final TokenSource files;
    private final DerivedPictures pictures;
    private final Map<Parameters, LampPicture> read = new IdentityHashMap<>();

    GlowingShapes(Spectra spectra, ImportDraft draft, TokenSource files, DerivedPictures pictures) {
        this.spectra = spectra;
        this.draft = draft;
        this.files = files;
        this.pictures = pictures;
    }

    /**
     * The picture of a lamp; empty if it has none.
     *
     * @param light the lamp's parameters; null for a shape that is no lamp
     * @param surface what the shape is made of, whose textures share one map of texture coordinates
     */
    Optional<LampPicture> picture(Parameters light, Surface surface) {
        if (light == null || !light.has("filename")) {
            return Optional.empty();
        }
        LampPicture picture = read.computeIfAbsent(light, p -> LampPicture.read(p, files, pictures, draft.notes()));
        if (surface.isTextured() && !surface.uv().equals(UvMap.IDENTITY)) {
            String place = light.place().shown();
            draft.notes().add(place, "the picture of a lamp whose surface has scaled textures becomes its mean");
            return Optional.of(picture.even(pictures, light.place()));
        }
        return Optional.of(picture);
    }

    /**
     * Adds a shape with the light that it is.
     *
     * @param picture what its radiance is multiplied by, if there is one
     */
    void add(
            ShapeDefinition shape,
            Form form,
            Affine map,
            Shape placed,
            Surface surface,
            Optional<LampPicture> picture) {
        boolean isTwoSided = shape.areaLight().isTrue("twosided", false);
        Rgb radiance = radiance(shape, form, map, isTwoSided, picture);
        if (radiance.max() == 0) {
            draft.object("", placed, reflecting(surface));
            return;
        }
        String place = shape.parameters().place().shown();
        if (!isTwoSided && picture.isEmpty() && isBlack(surface)) {
            Optional<Light> pane = parallelogram(form, map, shape.isReversed(), radiance);
            if (pane.isPresent()) {
                draft.light(pane.get());
                return;
            }
        }
        boolean isTurned = !isTwoSided && isTurned(form, placed, map, shape.isReversed());
        boolean isInwards = isTurned && !Fronts.isTurnable(placed);
        Material.EmissionPattern.Side oneSide =
                isInwards ? Material.EmissionPattern.Side.BACK : Material.EmissionPattern.Side.FRONT;
        Material.EmissionPattern pattern = new Material.EmissionPattern(
                picture.flatMap(LampPicture::texture), isTwoSided ? Material.EmissionPattern.Side.BOTH : oneSide);
        draft.object(
                "",
                isTurned && !isInwards ? Fronts.turned(placed) : placed,
                glowing(surface, radiance, pattern, place));
    }

    /** Whether the front of a placed shape is not the side of its normal. */
    private static boolean isTurned(Form form, Shape placed, Affine map, boolean isReversed) {
        if (placed instanceof Mesh) {
            return facesBack(PlacedForms.triangles(form), map, isReversed);
        }
        return isReversed != (placed instanceof Disk && map.determinant() < 0);
    }

    private Rgb radiance(
            ShapeDefinition shape, Form form, Affine map, boolean isTwoSided, Optional<LampPicture> picture) {
        Parameters p = shape.areaLight();
        Rgb color = picture.isPresent()
                ? picture.get().factor()
                : spectra.rgb(p, "L", Spectra.Kind.LIGHT, shape.areaLightSpace(), Rgb.WHITE);
        double scale = Math.max(0, p.number("scale", 1));
        double power = p.number("power", -1);
        if (power > 0) {
            double mean = picture.map(LampPicture::luminance).orElse(1.0);
            double sides = isTwoSided ? 2 : 1;
            scale *= mean > 0 ? power / (StrictMath.PI * area(form, map) * sides * mean) : 0;
        }
        return color.times(Rgb.gray(scale));
    }

    private static Material reflecting(Surface surface) {
        return surface.isInterface() ? Material.Matte.of(Texture.of(Rgb.BLACK)) : surface.material();
    }

    private static boolean isBlack(Surface surface) {
        return surface.isInterface() || GlowingMaterial.isBlack(surface.material());
    }

    private Material glowing(Surface surface, Rgb radiance, Material.EmissionPattern pattern, String place) {
        Optional<Material> both =
                surface.isInterface() ? Optional.empty() : GlowingMaterial.of(surface.material(), radiance, pattern);
        if (both.isEmpty() && !surface.isInterface()) {
            draft.notes()
                    .add(
                            place,
                            "a lamp whose material is " + surface.material().type()
                                    + " reflects nothing and has no holes");
        }
        return both.orElseGet(() -> GlowingMaterial.black(radiance, pattern));
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
