package enlightenment.importer.pbrt;

import enlightenment.color.Rgb;
import enlightenment.importer.support.SpectrumRgb;
import enlightenment.material.Glossy;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** Spectra that pbrt-v4 has by name. */
final class NamedSpectra {
    /**
     * A kind of glass.
     *
     * @param index of refraction at 587.6 nm
     * @param abbe its Abbe number
     */
    record GlassType(double index, OptionalDouble abbe) {
        GlassType(double index, double abbe) {
            this(index, OptionalDouble.of(abbe));
        }
    }

    /** From the data sheets of Schott. */
    private static final Map<String, GlassType> GLASS = Map.of(
            "glass-BK7", new GlassType(1.5168, 64.17),
            "glass-BAF10", new GlassType(1.6700, 47.11),
            "glass-FK51A", new GlassType(1.4866, 84.47),
            "glass-LASF9", new GlassType(1.8503, 32.17),
            "glass-F5", new GlassType(1.6034, 38.03),
            "glass-F10", new GlassType(1.6229, 36.90),
            "glass-F11", new GlassType(1.6206, 36.20),
            "glass-SF5", new GlassType(1.6727, 32.21),
            "glass-SF10", new GlassType(1.7283, 28.41),
            "glass-SF11", new GlassType(1.7847, 25.76));

    /** Chromaticity coordinates x, y of illuminants (CIE 15). */
    private static final Map<String, double[]> ILLUMINANTS = Map.ofEntries(
            Map.entry("stdillum-A", new double[] {0.44757, 0.40745}),
            Map.entry("stdillum-D50", new double[] {0.34567, 0.35850}),
            Map.entry("stdillum-D65", new double[] {0.31272, 0.32903}),
            Map.entry("stdillum-F1", new double[] {0.31310, 0.33727}),
            Map.entry("stdillum-F2", new double[] {0.37208, 0.37529}),
            Map.entry("stdillum-F3", new double[] {0.40910, 0.39430}),
            Map.entry("stdillum-F4", new double[] {0.44018, 0.40329}),
            Map.entry("stdillum-F5", new double[] {0.31379, 0.34531}),
            Map.entry("stdillum-F6", new double[] {0.37790, 0.38835}),
            Map.entry("stdillum-F7", new double[] {0.31292, 0.32933}),
            Map.entry("stdillum-F8", new double[] {0.34588, 0.35875}),
            Map.entry("stdillum-F9", new double[] {0.37417, 0.37281}),
            Map.entry("stdillum-F10", new double[] {0.34609, 0.35986}),
            Map.entry("stdillum-F11", new double[] {0.38052, 0.37713}),
            Map.entry("stdillum-F12", new double[] {0.43695, 0.40441}),
            Map.entry("illum-acesD60", new double[] {0.32168, 0.33767}));

    /** Crystals that pbrt counts among the metals: indices of refraction in visible light, without absorption. */
    private static final Map<String, Double> CRYSTALS = Map.of("MgO", 1.735, "TiO2", 2.61);

    private NamedSpectra() {}

    static Optional<GlassType> glass(String name) {
        return Optional.ofNullable(GLASS.get(name));
    }

    /** The colour of an illuminant, at luminance 1. */
    static Optional<Rgb> light(String name) {
        return Optional.ofNullable(ILLUMINANTS.get(name)).map(xy -> SpectrumRgb.ofChromaticity(xy[0], xy[1]));
    }

    /** The real or imaginary part of a metal's index of refraction by band, for {@code metal-Ag-eta} or {@code metal-Ag-k}. */
    static Optional<Rgb> metal(String name) {
        boolean isEta = name.endsWith("-eta");
        if (!name.startsWith("metal-") || !isEta && !name.endsWith("-k")) {
            return Optional.empty();
        }
        String symbol = name.substring("metal-".length(), name.lastIndexOf('-'));
        if (CRYSTALS.containsKey(symbol)) {
            return Optional.of(isEta ? Rgb.gray(CRYSTALS.get(symbol)) : Rgb.BLACK);
        }
        return Glossy.Metal.of(symbol)
                .map(m -> isEta ? m.conductor().eta() : m.conductor().k());
    }
}
