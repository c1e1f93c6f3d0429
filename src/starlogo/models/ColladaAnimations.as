package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.models.collada.ColladaAnimationReader;
    import starlogo.models.files.ModelFile;

    /**
     * The animations of a COLLADA document, as poses of the ColladaModel of the same document.
     *
     * <p>Each animation clip is an animation, whose time 0 is the clip's start. If there are no clips, all animations of the document are one
     * animation without a name. Channels move the transforms of nodes, whole or by their components, and the weights of morphs; channels of
     * other things (lights, cameras, materials) are ignored. Keys are LINEAR, STEP or BEZIER. Each number is interpolated on its own, those of a
     * matrix too.</p>
     *
     * <p>The points of a skin stand where its joints put them. If a joint is in the scene several times, because several nodes place the node
     * that it is in, a skin follows the joint in the innermost node around both. A morph has its weights. A <code>ColladaModel</code> shows its
     * base shape.</p>
     */
    public final class ColladaAnimations extends ModelAnimations
    {
        /**
         * Reads the animations of a document. If there are any, it reads the scene too.
         *
         * @param name the model's name, for errors
         * @param text the document's text
         * @param upAxis the same as for the ColladaModel
         * @throws ModelError as ColladaModel, or if an animation, skin or morph is wrong
         */
        public function ColladaAnimations(name:String, text:String, upAxis:Object = null)
        {
            super(ColladaAnimationReader.allIn(name, text, upAxis));
        }

        /**
         * Reads the animations of a document from a file's bytes, as <code>ColladaModel.fromBytes()</code>.
         *
         * @param name the model's name, for errors
         * @param bytes the whole file; its position may change
         * @param upAxis the same as for the ColladaModel
         * @throws ModelError as the constructor
         */
        public static function fromBytes(name:String, bytes:ByteArray, upAxis:Object = null):ColladaAnimations
        {
            return new ColladaAnimations(name, new ModelFile(name, bytes).requireText(), upAxis);
        }
    }
}
