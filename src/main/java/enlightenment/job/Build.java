package enlightenment.job;

import java.lang.module.ModuleDescriptor;

/** Which Enlightenment this is: parts, servers and workers go together only if it is the same. */
public final class Build {
    private Build() {}

    /** The version from the jar's manifest or the module, or "development" where classes run without a jar. */
    public static String number() {
        String manifest = Build.class.getPackage().getImplementationVersion();
        if (manifest != null) {
            return manifest;
        }
        ModuleDescriptor module = Build.class.getModule().getDescriptor();
        return module == null ? "development" : module.rawVersion().orElse("development");
    }
}
