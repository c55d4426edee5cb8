package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.importer.support.SpectrumRgb;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;

/** Makes linear sRGB of spectra: of rgb, of wavelengths with values, of names, of files and of temperatures. */
final class Spectra {
    /** What a spectrum is. */
    enum Kind {
        /** A share of light: at most 1. */
        ALBEDO,
        /** An index of refraction or coefficient. */
        UNBOUNDED,
        /** Light: rgb counts as it is, of other spectra only the colour, at luminance 1, as in pbrt-v4. */
        LIGHT
    }

    private final TokenSource files;

    /** @param files where files that hold spectra are found */
    Spectra(TokenSource files) {
        this.files = files;
    }

    Rgb rgb(Parameters parameters, String name, Kind kind, ColorSpace space, Rgb usual) {
        return parameters.find(name).map(p -> rgb(p, kind, space)).orElse(usual);
    }

    private Rgb rgb(Parameter p, Kind kind, ColorSpace space) {
        try {
            Rgb color = value(p, kind, space);
            return kind == Kind.ALBEDO
                    ? new Rgb(Math.min(1, color.r()), Math.min(1, color.g()), Math.min(1, color.b()))
                    : color;
        } catch (IllegalArgumentException e) {
            throw p.place().failure(Plain.quoted(p.type() + " " + p.name()) + ": " + e.getMessage());
        }
    }

    private Rgb value(Parameter p, Kind kind, ColorSpace space) {
        double[] n = p.numbers();
        switch (p.type()) {
            case "rgb":
                require(n.length == 3, "must be three numbers");
                return space.rgb(n[0], n[1], n[2]);
            case "blackbody":
                require(n.length == 1, "must be a temperature in kelvin");
                return SpectrumRgb.blackbody(n[0]);
            case "float":
                require(n.length == 1 && n[0] >= 0, "must be one number, at least 0");
                return Rgb.gray(n[0]);
            case "spectrum":
                return spectrum(p, kind);
            default:
                throw new IllegalArgumentException("must be an rgb, spectrum or blackbody");
        }
    }

    private Rgb spectrum(Parameter p, Kind kind) {
        if (p.words().size() == 1) {
            String name = p.words().get(0);
            Optional<Rgb> known = kind == Kind.LIGHT ? NamedSpectra.light(name) : NamedSpectra.metal(name);
            if (known.isEmpty() && kind == Kind.UNBOUNDED) {
                known = NamedSpectra.glass(name).map(g -> Rgb.gray(g.index()));
            }
            return known.orElseGet(() -> converted(file(name, p.place()), kind));
        }
        require(p.words().isEmpty(), "must be one name or pairs of numbers");
        return converted(pairs(p.numbers()), kind);
    }

    private static Rgb converted(DoubleUnaryOperator spectrum, Kind kind) {
        return kind == Kind.LIGHT ? SpectrumRgb.ofLight(spectrum) : SpectrumRgb.underDaylight(spectrum);
    }

    private static DoubleUnaryOperator pairs(double[] n) {
        require(n.length > 0 && n.length % 2 == 0, "must be pairs of wavelength and value");
        double[] wavelengths = new double[n.length / 2];
        double[] values = new double[n.length / 2];
        for (int i = 0; i < wavelengths.length; i++) {
            wavelengths[i] = n[2 * i];
            values[i] = n[2 * i + 1];
        }
        return SpectrumRgb.linear(wavelengths, values);
    }

    private DoubleUnaryOperator file(String name, Place place) {
        if (name.indexOf('.') < 0) {
            throw place.failure("there is no spectrum named " + Plain.quoted(name) + " here");
        }
        Path file = files.file(name, place);
        Numbers numbers = new Numbers();
        try (Lexer lexer = new Lexer(file, false)) {
            for (Token t = lexer.next(); t != null; t = lexer.next()) {
                numbers.add(TokenSource.number(t, "pairs of wavelength and value"));
            }
        } catch (IOException e) {
            throw place.failure(Plain.quoted(name) + " cannot be read: " + e.getMessage());
        }
        return pairs(numbers.toArray());
    }

    private static void require(boolean isTrue, String message) {
        if (!isTrue) {
            throw new IllegalArgumentException(message);
        }
    }
}
