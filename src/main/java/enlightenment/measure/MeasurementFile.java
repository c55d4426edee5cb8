package enlightenment.measure;

import enlightenment.image.Image;
import enlightenment.measure.trade.Reference;
import enlightenment.measure.trade.TradeResult;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The file of the reference's figures and the conditions, one {@code key=value} per line. */
final class MeasurementFile {
    private static final String VARIANCE = "reference.variance";
    private static final String PART = "reference.part";
    private static final String COLD = "coldSeconds";
    private static final String SECONDS = "seconds";
    private static final String COMPLETE = "complete";
    private static final String MACHINE = "machine.";
    private static final int PART_FIELDS = 4;

    private MeasurementFile() {}

    /** The content of the file. */
    record Content(Reference reference, TradeResult.Conditions conditions) {}

    static List<String> lines(Reference reference, TradeResult.Conditions c) {
        List<String> lines = new ArrayList<>();
        lines.add(VARIANCE + "=" + reference.variance());
        for (Reference.Part p : reference.parts()) {
            lines.add(PART + "=" + text(p));
        }
        lines.add(COLD + "=" + c.coldSeconds());
        lines.add(SECONDS + "=" + c.seconds());
        lines.add(COMPLETE + "=" + c.complete());
        c.machine().forEach((k, v) -> lines.add(MACHINE + k + "=" + v));
        return lines;
    }

    static Content parse(Path file, Optional<Image> picture) throws IOException {
        double variance = Double.NaN;
        List<Reference.Part> parts = new ArrayList<>();
        Map<String, String> machine = new LinkedHashMap<>();
        double cold = 0;
        double seconds = 0;
        boolean complete = false;
        for (String line : Files.readAllLines(file)) {
            int equals = line.indexOf('=');
            String key = line.substring(0, Math.max(equals, 0));
            String value = line.substring(equals + 1);
            try {
                switch (key) {
                    case VARIANCE -> variance = Double.parseDouble(value);
                    case PART -> parts.add(part(value));
                    case COLD -> cold = Double.parseDouble(value);
                    case SECONDS -> seconds = Double.parseDouble(value);
                    case COMPLETE -> complete = Boolean.parseBoolean(value);
                    default -> {
                        if (!key.startsWith(MACHINE)) {
                            throw new NumberFormatException(line);
                        }
                        machine.put(key.substring(MACHINE.length()), value);
                    }
                }
            } catch (NumberFormatException e) {
                throw new IOException(file + ": is not what the command trade wrote: \"" + line + "\"", e);
            }
        }
        if (!(variance >= 0)) {
            throw new IOException(file + ": is not what the command trade wrote: " + VARIANCE + " is missing");
        }
        return new Content(
                new Reference(picture, variance, parts), new TradeResult.Conditions(machine, cold, seconds, complete));
    }

    /** A part of the reference in one line. */
    static String text(Reference.Part p) {
        return p.method() + "," + p.lightSamples() + "," + p.samples() + "," + p.seed();
    }

    /** The part of the reference that a file of one line describes. */
    static Reference.Part part(Path file) throws IOException {
        try {
            return part(Files.readString(file).strip());
        } catch (NumberFormatException e) {
            throw new IOException(file + ": is not what the command trade wrote", e);
        }
    }

    private static Reference.Part part(String value) {
        String[] f = value.split(",", -1);
        if (f.length != PART_FIELDS) {
            throw new NumberFormatException(value);
        }
        return new Reference.Part(f[0], Integer.parseInt(f[1]), Double.parseDouble(f[2]), Long.parseLong(f[3]));
    }
}
