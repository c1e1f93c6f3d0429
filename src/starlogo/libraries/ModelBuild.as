package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.geometry.GeometryFingerprint;
    import starlogo.solid.SolidHierarchyBuilder;
    import starlogo.libraries.cooked.FitsReader;
    import starlogo.libraries.cooked.FitsWriter;
    import starlogo.libraries.cooked.TreeReader;
    import starlogo.models.Model;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * Gets for one model what the libraries need: from a baked file, or else from a store; what neither has is computed, and kept in the store.
     *
     * @private
     */
    public final class ModelBuild implements Steps
    {
        private var _model:Model;
        private var _structures:StructuresBuild;
        private var _hierarchy:SolidHierarchyBuilder;
        private var _settings:FitSettings;
        private var _baked:ByteArray;
        private var _store:FitStore;
        private var _geometry:GeometryFingerprint;
        private var _fits:ModelFits = new ModelFits();
        private var _work:StepSequence = new StepSequence();

        /**
         * @param model the model
         * @param structures finds its structures; null if none are wanted
         * @param hierarchy builds its hierarchy; null if none is wanted
         * @param settings those of the libraries that these two are of
         * @param baked the bytes of its .fits file, which are not trusted; null for none
         * @param store null for none
         */
        public function ModelBuild(model:Model, structures:StructuresBuild, hierarchy:SolidHierarchyBuilder, settings:FitSettings,
                baked:ByteArray, store:FitStore)
        {
            _model = model;
            _structures = structures;
            _hierarchy = hierarchy;
            _settings = settings;
            _baked = baked;
            _store = store;
            _geometry = new GeometryFingerprint(model.vertices, model.triangles);
            if (baked != null || store != null)
            {
                _work.add(_geometry).begin(readBaked).begin(readStored).call(useFits);
            }
            if (structures != null)
            {
                _work.add(structures);
            }
            if (hierarchy != null)
            {
                _work.begin(divide);
            }
            if (store != null)
            {
                _work.call(keep);
            }
        }

        /** The structures, when no step is left; null if none were wanted. */
        public function get structures():ShapeStructures
        {
            return _structures == null ? null : _structures.structures;
        }

        /** Whether the structures were read, when no step is left. */
        public function get areStructuresRead():Boolean
        {
            return _structures != null && _structures.isRead;
        }

        /** The builder that has the hierarchy, or builds it when it is needed; when no step is left. Null if none was wanted. */
        public function get hierarchy():SolidHierarchyBuilder
        {
            return _hierarchy;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            return _work.step();
        }

        /**
         * The content of a .fits file of the model, including the surface, when no step is left of a build without a baked file and a store. If the
         * surface is not prepared, that is done now.
         */
        public function toFits():ByteArray
        {
            if (_hierarchy != null)
            {
                _hierarchy.finished.prepare();
            }
            finish(_geometry);
            return write();
        }

        private function readBaked():Steps
        {
            return newReader(_baked);
        }

        private function readStored():Steps
        {
            var isComplete:Boolean = (_structures == null || _fits.structures != null) && (_hierarchy == null || _fits.tree != null)
                && (!wantsSurface || _fits.notes != null);
            return newReader(_store == null || isComplete ? null : _store.bytesOf(geometry, _settings));
        }

        private function newReader(bytes:ByteArray):FitsReader
        {
            return bytes == null ? null : new FitsReader(bytes, _model, geometry, _settings, _fits);
        }

        private function useFits():void
        {
            if (_structures != null && _fits.structures != null)
            {
                _structures.useRead(_fits.structures);
            }
            if (_hierarchy != null && _fits.tree != null)
            {
                _hierarchy.useStored(new TreeReader(_fits.tree), _fits.notes);
            }
        }

        // What is known already waits until it is needed, unless all is to be prepared.
        private function divide():Steps
        {
            return _hierarchy.isTaken && !_settings.wantsSurface ? null : _hierarchy;
        }

        private function keep():void
        {
            var isNew:Boolean = _structures != null && !_structures.isRead || _hierarchy != null && !_hierarchy.isTaken
                || wantsSurface && _hierarchy.hierarchy.notes !== _fits.notes;
            if (isNew && _store.mayHold(_model))
            {
                _store.keep(geometry, _settings, write());
            }
        }

        private function write():ByteArray
        {
            return FitsWriter.write(ModelFits.of(structures, _hierarchy == null ? null : _hierarchy.finished), geometry, _settings);
        }

        private function get wantsSurface():Boolean
        {
            return _settings.wantsSurface && _model.triangles != null;
        }

        private function get geometry():Fingerprint
        {
            return _geometry.fingerprint;
        }
    }
}
