package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Texture;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.scene.Shading;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Path;

/**
 * Lights without a surface. As in pbrt-v4, an rgb is the light in these numbers, and any other spectrum has luminance 1; both are multiplied by
 * {@code scale}.
 */
final class Lights {
    /** The widest square picture of all directions. */
    private static final int WIDEST = 1 << 13;

    private final TokenSource files;
    private final Spectra spectra;
    private final ImportDraft draft;
    private final ExtractedFiles extracted;
    private final DirectedLights directed;
    private boolean hasSurroundings;

    Lights(TokenSource files, Spectra spectra, ImportDraft draft, ExtractedFiles extracted, DerivedPictures pictures) {
        this.files = files;
        this.spectra = spectra;
        this.draft = draft;
        this.extracted = extracted;
        directed = new DirectedLights(files, spectra, draft, pictures);
    }

    void add(String type, Parameters p, Affine toWorld, ColorSpace space) {
        switch (type) {
            case "point":
                point(p, toWorld, space);
                break;
            case "goniometric":
                note(p, "a goniometric light shines to all sides alike");
                point(p, toWorld, space);
                break;
            case "distant":
                distant(p, toWorld, space);
                break;
            case "infinite":
                infinite(p, toWorld, space);
                break;
            case "spot":
                directed.spot(p, toWorld, space);
                break;
            case "projection":
                directed.projection(p, toWorld);
                break;
            default:
                throw p.place().failure("pbrt-v4 has no light of the kind " + Plain.quoted(type));
        }
    }

    private void note(Parameters p, String message) {
        draft.notes().add(p.place().shown(), message);
    }

    static double scale(Parameters p) {
        return Math.max(0, p.number("scale", 1));
    }

    private void point(Parameters p, Affine toWorld, ColorSpace space) {
        Rgb color = spectra.rgb(p, "I", Spectra.Kind.LIGHT, space, Rgb.WHITE);
        double power = p.number("power", -1);
        double factor = scale(p) * (power > 0 ? power / (4 * StrictMath.PI) : 1);
        Vec3 from = toWorld.point(p.vector("from", Vec3.ZERO));
        Rgb intensity = color.times(Rgb.gray(factor));
        if (intensity.max() > 0) {
            draft.light(new Light.Point(Affine.exact(from), Rgb.WHITE, Emission.intensity(intensity)));
        }
    }

    /** From one point to another; the disk is as wide as the sun's, not a point as in pbrt. */
    private void distant(Parameters p, Affine toWorld, ColorSpace space) {
        Rgb color = spectra.rgb(p, "L", Spectra.Kind.LIGHT, space, Rgb.WHITE);
        double illuminance = p.number("illuminance", -1);
        Rgb irradiance = color.times(Rgb.gray(scale(p) * (illuminance > 0 ? illuminance : 1)));
        Vec3 way = p.vector("to", Vec3.Z).minus(p.vector("from", Vec3.ZERO));
        try {
            Light light = new Light.Distant(toWorld.vector(way), irradiance);
            if (irradiance.max() > 0) {
                draft.light(light);
            }
        } catch (InvalidValueException e) {
            throw p.place().failure(e.getMessage());
        }
    }

    private void infinite(Parameters p, Affine toWorld, ColorSpace space) {
        if (hasSurroundings) {
            note(p, "of several infinite lights the first one stays");
            return;
        }
        hasSurroundings = true;
        if (p.has("portal")) {
            note(p, "an infinite light shines from all sides, not through its portal alone");
        }
        double illuminance = p.number("illuminance", -1);
        if (p.has("filename")) {
            picture(p, toWorld, illuminance);
        } else {
            Rgb color = spectra.rgb(p, "L", Spectra.Kind.LIGHT, space, Rgb.WHITE);
            double factor = scale(p) * (illuminance > 0 ? illuminance / StrictMath.PI : 1);
            draft.background(new Shading.Background.Constant(color.times(Rgb.gray(factor))));
        }
    }

    private void picture(Parameters p, Affine toWorld, double illuminance) {
        String name = p.string("filename", "");
        Path file = files.file(name, p.place());
        try {
            Image image = ImageFiles.read(file);
            if (image.width() != image.height() || image.width() > WIDEST) {
                throw p.place()
                        .failure(Plain.quoted(name) + " has " + image.width() + " x " + image.height()
                                + " pixels; an infinite light needs a square picture by the equal-area map, of at most "
                                + WIDEST + " x " + WIDEST);
            }
            EqualAreaMap map = new EqualAreaMap(image, !DerivedPictures.isOfFloats(file));
            double given = map.illuminance();
            double factor = scale(p) * (illuminance > 0 && given > 0 ? illuminance / given : 1);
            Image turned = map.byLongitude(toWorld);
            Path written = extracted.write("pfm", out -> ImageFiles.toPfm(turned, out));
            Texture.File texture = new Texture.File(written, Texture.Filter.BILINEAR, Texture.Encoding.LINEAR);
            draft.background(new Shading.Background.Picture(texture, Rgb.gray(factor), 0));
        } catch (IOException e) {
            throw p.place().failure(e.getMessage());
        }
    }
}
