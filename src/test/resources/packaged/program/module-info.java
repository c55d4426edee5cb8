module program {
    requires enlightenment;
    requires java.desktop;
}
