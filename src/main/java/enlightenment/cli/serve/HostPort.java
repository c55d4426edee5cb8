package enlightenment.cli.serve;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.WholeNumber;
import picocli.CommandLine.ITypeConverter;

/** The address of a server; an IPv6 address has no brackets here. */
record HostPort(String host, int port) {
    /** Reads {@code HOST:PORT}, with an IPv6 address in brackets. */
    static final class Converter implements ITypeConverter<HostPort> {
        @Override
        public HostPort convert(String text) {
            int colon = text.lastIndexOf(':');
            int[] port = WholeNumber.several(text.substring(colon + 1), " ", 1);
            if (colon < 1 || port == null || port[0] < 1 || port[0] > WholeNumber.Port.MAX) {
                throw BadValue.expected(
                        "the server's address such as 10.0.0.5:6002, with a port in 1.." + WholeNumber.Port.MAX, text);
            }
            return new HostPort(text.substring(0, colon).replaceAll("^\\[(.*)]$", "$1"), port[0]);
        }
    }
}
