package enlightenment.cli.terminal;

import java.lang.module.ModuleDescriptor;
import picocli.CommandLine.IVersionProvider;

/** Which Enlightenment this is. */
public final class Version implements IVersionProvider {
    Version() {}

    /** The version from the jar's manifest or the module, or "development" where classes run without a jar. */
    public static String number() {
        String manifest = Version.class.getPackage().getImplementationVersion();
        if (manifest != null) {
            return manifest;
        }
        ModuleDescriptor module = Version.class.getModule().getDescriptor();
        return module == null ? "development" : module.rawVersion().orElse("development");
    }

    /** One line for the user, with what it runs on. */
    public static String line() {
        return "enlightenment " + number() + " (Java " + Runtime.version() + ")";
    }

    @Override
    public String[] getVersion() {
        return new String[] {line()};
    }
}
