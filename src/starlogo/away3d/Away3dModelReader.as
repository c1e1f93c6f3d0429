package starlogo.away3d
{
    import starlogo.models.Model;
    import starlogo.models.ModelMaker;
    import starlogo.models.building.ModelBuilder;

    /**
     * Makes an Away3dModel in steps, while a game runs. Give it to a ModelLoader.
     *
     * <listing version="3.0">
     * loader.loadFrom(new Away3dModelReader("bear", mesh));
     * </listing>
     *
     * <p>The source must not change until all steps are done.</p>
     */
    public final class Away3dModelReader implements ModelMaker
    {
        private var _builder:ModelBuilder;
        private var _model:Away3dModel = null;

        /**
         * Creates the reader. It does nothing yet.
         *
         * @param name what agents call the shape
         * @param object as for Away3dModel
         */
        public function Away3dModelReader(name:String, object:Object)
        {
            _builder = new SourceReader(name, object).building();
        }

        /** @inheritDoc */
        public function get name():String
        {
            return _builder.name;
        }

        /** @inheritDoc */
        public function get progress():Number
        {
            return _builder.progress;
        }

        /** The Away3dModel, always the same one. Read it when no step is left. */
        public function get model():Model
        {
            return _model ||= new Away3dModel(name, _builder);
        }

        /**
         * @inheritDoc
         *
         * @throws ModelError as Away3dModel()
         */
        public function step():Boolean
        {
            return _builder.step();
        }
    }
}
