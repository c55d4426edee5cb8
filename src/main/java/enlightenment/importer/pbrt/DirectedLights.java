package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ImportDraft;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import java.nio.file.Path;

/** Points that shine into a cone or project a picture: along +z of their coordinates, the picture with +x to the right and +y upwards. */
final class DirectedLights {
    private static final double USUAL_CONE = 30;
    private static final double USUAL_EDGE = 5;
    private static final double USUAL_FIELD = 90;

    private final TokenSource files;
    private final Spectra spectra;
    private final ImportDraft draft;
    private final DerivedPictures pictures;

    DirectedLights(TokenSource files, Spectra spectra, ImportDraft draft, DerivedPictures pictures) {
        this.files = files;
        this.spectra = spectra;
        this.draft = draft;
        this.pictures = pictures;
    }

    /** A spotlight, whose intensity falls by the smoothstep of the cosine over the last {@code conedeltaangle} degrees of its cone. */
    void spot(Parameters p, Affine toWorld, ColorSpace space) {
        double cone = p.number("coneangle", USUAL_CONE);
        if (!(cone > 0 && cone <= 180)) {
            throw p.place().failure("a coneangle must be above 0 and at most 180 degrees, not " + cone);
        }
        double inner = Math.min(cone, Math.abs(cone - p.number("conedeltaangle", USUAL_EDGE)));
        Vec3 from = p.vector("from", Vec3.ZERO);
        Vec3 direction = toWorld.vector(p.vector("to", Vec3.Z).minus(from));
        if (!(direction.maxAbs() > 0)) {
            throw p.place().failure("a spot light must have \"to\" apart from \"from\"");
        }
        Rgb color = spectra.rgb(p, "I", Spectra.Kind.LIGHT, space, Rgb.WHITE);
        double power = p.number("power", -1);
        double solidAngle = StrictMath.PI * (2 - cosine(inner) - cosine(cone));
        Rgb intensity = color.times(Rgb.gray(Lights.scale(p) * (power > 0 ? power / solidAngle : 1)));
        if (intensity.max() > 0) {
            draft.light(new Light.Spot(
                    Affine.exact(toWorld.point(from)),
                    direction,
                    cone,
                    inner,
                    Rgb.WHITE,
                    Emission.intensity(intensity)));
        }
    }

    private static double cosine(double degrees) {
        return StrictMath.cos(StrictMath.toRadians(degrees));
    }

    /** A projector; in pbrt {@code fov} spans the shorter side of its picture. */
    void projection(Parameters p, Affine toWorld) {
        double fov = p.number("fov", USUAL_FIELD);
        if (!(fov > 0 && fov < 180)) {
            throw p.place().failure("a fov must be an angle between 0 and 180 degrees, not " + fov);
        }
        Path file = files.file(p.string("filename", ""), p.place());
        boolean isOfFloats = DerivedPictures.isOfFloats(file);
        Texture.File source = new Texture.File(
                file, Texture.Filter.NEAREST, isOfFloats ? Texture.Encoding.LINEAR : Texture.Encoding.SRGB);
        Image picture = pictures.linear(source, p.place());
        double largest = DerivedPictures.largest(picture, 0);
        double power = p.number("power", -1);
        double scale = Lights.scale(p);
        if (!(largest > 0 && scale > 0)) {
            return;
        }
        Vec3 direction = toWorld.vector(Vec3.Z);
        Vec3 up = toWorld.vector(Vec3.Y);
        // Ours has up x direction to its right, which is +x unless the map mirrors.
        boolean isMirrored = up.cross(direction).dot(toWorld.vector(Vec3.X)) < 0;
        double brightest = isOfFloats ? largest : 1;
        draft.light(new Light.Projector(
                Affine.exact(toWorld.offset()),
                isOfFloats || isMirrored
                        ? pictures.write(fitted(picture, brightest, isMirrored), source.filter(), p.place())
                        : source,
                direction,
                up,
                width(fov, (double) picture.width() / picture.height()),
                Rgb.WHITE,
                power > 0 ? Emission.power(Rgb.gray(scale * power)) : Emission.intensity(Rgb.gray(scale * brightest))));
    }

    /** Degrees across the width, of those across the shorter side. */
    private static double width(double degrees, double aspect) {
        return aspect > 1
                ? 2 * StrictMath.toDegrees(StrictMath.atan(aspect * StrictMath.tan(StrictMath.toRadians(degrees / 2))))
                : degrees;
    }

    private static Image fitted(Image linear, double brightest, boolean isMirrored) {
        int width = linear.width();
        float[] rgb = new float[3 * width * linear.height()];
        for (int y = 0; y < linear.height(); y++) {
            for (int x = 0; x < width; x++) {
                for (int c = 0; c < 3; c++) {
                    int from = isMirrored ? width - 1 - x : x;
                    rgb[3 * (y * width + x) + c] = (float) (linear.component(from, y, c) / brightest);
                }
            }
        }
        return new Image(width, linear.height(), rgb);
    }
}
