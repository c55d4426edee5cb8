package enlightenment.importer.mitsuba;

import enlightenment.text.Plain;
import java.util.Locale;
import java.util.Map;

/** Indices of refraction by the names that Mitsuba gives to matter. */
final class IndexOfRefraction {
    private static final Map<String, Double> BY_NAME = Map.ofEntries(
            Map.entry("vacuum", 1.0),
            Map.entry("helium", 1.000036),
            Map.entry("hydrogen", 1.000132),
            Map.entry("air", 1.000277),
            Map.entry("carbon dioxide", 1.00045),
            Map.entry("water", 1.3330),
            Map.entry("acetone", 1.36),
            Map.entry("ethanol", 1.361),
            Map.entry("carbon tetrachloride", 1.461),
            Map.entry("glycerol", 1.4729),
            Map.entry("benzene", 1.501),
            Map.entry("silicone oil", 1.52045),
            Map.entry("bromine", 1.661),
            Map.entry("water ice", 1.31),
            Map.entry("fused quartz", 1.458),
            Map.entry("pyrex", 1.470),
            Map.entry("acrylic glass", 1.49),
            Map.entry("polypropylene", 1.49),
            Map.entry("bk7", 1.5046),
            Map.entry("sodium chloride", 1.544),
            Map.entry("amber", 1.55),
            Map.entry("pet", 1.5750),
            Map.entry("diamond", 2.419));

    private IndexOfRefraction() {}

    /** The index inside over that outside; {@code int_ior} and {@code ext_ior} are numbers or names. */
    static double relative(Properties p, String otherwise) {
        double inside = p.find("int_ior").map(IndexOfRefraction::read).orElse(BY_NAME.get(otherwise));
        double outside = p.find("ext_ior").map(IndexOfRefraction::read).orElse(BY_NAME.get("air"));
        return inside / outside;
    }

    private static double read(XmlElement e) {
        String text = e.attribute("value");
        Double named = BY_NAME.get(text.strip().toLowerCase(Locale.ROOT));
        if (named != null) {
            return named;
        }
        if (e.tag().equals("string")) {
            throw e.failure("is of no matter whose index of refraction is known: " + Plain.quoted(text));
        }
        double v = Properties.number(e, text);
        if (!(v > 0)) {
            throw e.failure("must be an index of refraction above 0, not " + Plain.quoted(text));
        }
        return v;
    }
}
