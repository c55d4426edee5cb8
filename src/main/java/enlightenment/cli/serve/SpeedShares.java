package enlightenment.cli.serve;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.DecimalNumber;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.ITypeConverter;

/** First guesses of the speeds of workers, by name or address; all others have 1. */
record SpeedShares(Map<String, Double> byHost) {
    private static final double MIN = 0.001;
    private static final double MAX = 1000;

    static final SpeedShares NONE = new SpeedShares(Map.of());

    /** As it is typed; like that of {@code AovSet}, because picocli asks for it at each start. */
    @Override
    public String toString() {
        List<String> shares = new ArrayList<>();
        byHost.forEach((host, weight) -> shares.add(host + "=" + DecimalNumber.plain(weight)));
        return String.join(",", shares);
    }

    /** Reads {@code HOST=WEIGHT,...}. */
    static final class Converter implements ITypeConverter<SpeedShares> {
        @Override
        public SpeedShares convert(String text) {
            Map<String, Double> byHost = new LinkedHashMap<>();
            for (String share : text.split(",", -1)) {
                int equals = share.lastIndexOf('=');
                if (equals < 1) {
                    throw BadValue.expected("HOST=WEIGHT,... such as fast=4,10.0.0.7=1.5", text);
                }
                byHost.put(share.substring(0, equals), DecimalNumber.parse(share.substring(equals + 1), MIN, MAX));
            }
            return new SpeedShares(Collections.unmodifiableMap(byHost));
        }
    }
}
