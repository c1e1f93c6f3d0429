package starlogo.models.building
{
    import starlogo.data.textOf;
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.models.ModelTransform;

    use namespace engine;

    /**
     * Throws a ModelError if an up axis is not "x", "y" or "z", or a ModelTransform in its place.
     *
     * @param name the model's name
     * @param upAxis what was given
     * @private
     */
    public function requireUpAxis(name:String, upAxis:Object):void
    {
        refuseIf(["x", "y", "z"].indexOf(upAxis) < 0 && !(upAxis is ModelTransform), name, "the up axis must be \"x\", \"y\" or \"z\", or a ModelTransform, not " + textOf(upAxis)
                + (Model.SCALINGS.indexOf(String(upAxis)) < 0 ? "" : ": a scaling is the argument after it"));
    }
}
