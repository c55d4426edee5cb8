package enlightenment.importer.mitsuba;

import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.colorimetry.BandSensitivities;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.importer.support.SpectrumRgb;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;

/** Colours and spectra as linear sRGB, as Mitsuba's variants for RGB have them. */
final class ColorValue {
    private static final int LARGEST_FILE = 1 << 20;

    /** Planck's law in W/(m² sr nm) with the wavelength in nanometres: 2 h c² (CODATA 2018). */
    private static final double FIRST_CONSTANT = 1.191042972e20;

    /** h c / k in nm K. */
    private static final double SECOND_CONSTANT = 1.438776877e7;

    private final SceneIndex scene;

    ColorValue(SceneIndex scene) {
        this.scene = scene;
    }

    /** A factor of light: a reflectance, an index of refraction. */
    Rgb factor(XmlElement e) {
        return read(e, false);
    }

    /** Light that is emitted. */
    Rgb light(XmlElement e) {
        return read(e, true);
    }

    private Rgb read(XmlElement e, boolean isLight) {
        return switch (e.tag()) {
            case "float", "integer" -> gray(e, Properties.number(e, e.attribute("value")));
            case "rgb" -> rgb(e, e.attribute("value").startsWith("#"));
            case "srgb" -> rgb(e, true);
            case "spectrum" -> e.type().equals("blackbody") ? blackbody(e) : spectrum(e, isLight);
            case "blackbody" -> blackbody(e);
            default -> throw e.failure("must be a colour: rgb, srgb, spectrum, float or blackbody");
        };
    }

    private static Rgb rgb(XmlElement e, boolean isEncoded) {
        String text = e.attribute("value").strip();
        double[] v;
        Optional<DisplayRgb> encoded = DisplayRgb.ofHexadecimal(text);
        if (encoded.isPresent()) {
            v = new double[] {
                encoded.get().r(), encoded.get().g(), encoded.get().b()
            };
        } else {
            v = Properties.numbers(e, text);
        }
        if (v.length != 1 && v.length != 3) {
            throw e.failure("must be three numbers, or one, not " + Plain.quoted(text));
        }
        if (isEncoded) {
            for (int i = 0; i < v.length; i++) {
                v[i] = TransferCurve.decode(v[i]);
            }
        }
        return v.length == 1 ? gray(e, v[0]) : color(e, v[0], v[1], v[2]);
    }

    private static Rgb gray(XmlElement e, double v) {
        return color(e, v, v, v);
    }

    private static Rgb color(XmlElement e, double r, double g, double b) {
        if (r < 0 || g < 0 || b < 0) {
            throw e.failure("must be a colour without negative components");
        }
        return new Rgb(r, g, b);
    }

    private Rgb spectrum(XmlElement e, boolean isLight) {
        String text = e.has("filename") ? content(e) : e.attribute("value").strip();
        if (!text.contains(":")) {
            double v = Properties.number(e, text);
            // A constant spectrum is equal energy, which is not the white of sRGB; 0.6 took it for white.
            return isLight && !scene.isOld() ? emitted(w -> v) : gray(e, v);
        }
        String[] pairs = text.split("[\\s,]+");
        double[] wavelengths = new double[pairs.length];
        double[] values = new double[pairs.length];
        for (int i = 0; i < pairs.length; i++) {
            int colon = pairs[i].indexOf(':');
            if (colon < 0) {
                throw e.failure("must be pairs wavelength:value, not " + Plain.quoted(pairs[i]));
            }
            wavelengths[i] = Properties.number(e, pairs[i].substring(0, colon));
            values[i] = Properties.number(e, pairs[i].substring(colon + 1));
        }
        try {
            DoubleUnaryOperator spectrum = SpectrumRgb.linear(wavelengths, values);
            return isLight ? emitted(spectrum) : SpectrumRgb.underDaylight(spectrum);
        } catch (IllegalArgumentException problem) {
            throw e.failure(problem.getMessage());
        }
    }

    /** A file of lines with wavelength and value, as pairs. */
    private String content(XmlElement e) {
        try {
            Path file = scene.file(e.attribute("filename"));
            if (Files.size(file) > LARGEST_FILE) {
                throw new IOException("a spectrum is longer than " + LARGEST_FILE + " bytes");
            }
            List<String> pairs = new ArrayList<>();
            for (String line : Files.readAllLines(file, StandardCharsets.ISO_8859_1)) {
                String stripped = line.strip();
                if (!stripped.isEmpty() && !stripped.startsWith("#")) {
                    pairs.add(stripped.replaceFirst("[\\s,]+", ":"));
                }
            }
            return String.join(" ", pairs);
        } catch (IOException problem) {
            throw e.failure("has no spectrum: " + problem.getMessage());
        }
    }

    private Rgb blackbody(XmlElement e) {
        double kelvin = e.has("temperature")
                ? Properties.number(e, e.attribute("temperature").replaceFirst("[kK]$", ""))
                : new Properties(e).number("temperature", 5000);
        double scale = e.has("scale") ? Properties.number(e, e.attribute("scale")) : 1;
        if (!(kelvin > 0) || scale < 0) {
            throw e.failure("must have a temperature above 0 kelvin, and no negative scale");
        }
        return emitted(
                w -> scale * FIRST_CONSTANT / StrictMath.pow(w, 5) / StrictMath.expm1(SECOND_CONSTANT / (w * kelvin)));
    }

    /** Light of this spectrum: its luminance is the mean over the eye's sensitivity. */
    private static Rgb emitted(DoubleUnaryOperator spectrum) {
        double sum = 0;
        double whole = 0;
        for (double w = BandSensitivities.SHORTEST + 0.5; w < BandSensitivities.LONGEST; w++) {
            double y = 0.2126 * BandSensitivities.matching(w, 0)
                    + 0.7152 * BandSensitivities.matching(w, 1)
                    + 0.0722 * BandSensitivities.matching(w, 2);
            sum += y * spectrum.applyAsDouble(w);
            whole += y;
        }
        return SpectrumRgb.ofLight(spectrum).times(Rgb.gray(StrictMath.max(sum / whole, 0)));
    }
}
