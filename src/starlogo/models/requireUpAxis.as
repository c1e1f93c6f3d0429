package starlogo.models
{
    import starlogo.data.textOf;
    import starlogo.engine;

    use namespace engine;

    /**
     * Throws a ModelError if an up axis is neither an axis nor a transform.
     *
     * @param name the model's name
     * @param upAxis what was given
     * @param isTransform whether it is a ModelTransform
     * @private
     */
    public function requireUpAxis(name:String, upAxis:Object, isTransform:Boolean):void
    {
        refuseIf(!isTransform && ["x", "y", "z"].indexOf(upAxis) < 0, name, "the up axis must be \"x\", \"y\" or \"z\", or a ModelTransform, not " + textOf(upAxis)
                + (Model.SCALINGS.indexOf(String(upAxis)) < 0 ? "" : ": a scaling is the argument after it"));
    }
}
