package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.geometry.VertexBounds;
    import starlogo.libraries.cooked.CookedStructures;
    import starlogo.libraries.cooked.CookedTree;
    import starlogo.models.Model;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedWriter;
    import starlogo.solid.ModelTree;
    import starlogo.solid.ModelTreeBuilder;
    import starlogo.solid.SurfaceTopology;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Gets the results that the libraries need for one model. It takes them from the model's cooked file, otherwise from a store. It
     * computes the results that are missing and adds them to the store.
     *
     * @private
     */
    public final class ModelResultsBuilder extends StepSequence
    {
        /** The builder that has the hierarchy or builds it when it is needed. Read it when no step is left. Null if none was wanted. */
        public var treeBuilder:ModelTreeBuilder;

        private var _model:Model;
        private var _structuresBuilder:StructuresBuilder;
        private var _settings:FitSettings;
        private var _store:FitStore;

        // For the store: the fingerprint of the model's vertices and triangles, and whether all results have come from there.
        private var _geometry:Fingerprint = new Fingerprint();
        private var _isStored:Boolean = false;

        /**
         * @param model the model
         * @param structuresBuilder finds its structures; null if none are wanted
         * @param treeBuilder builds its hierarchy; null if none is wanted
         * @param settings the settings of the libraries that want them
         * @param store null for none
         */
        public function ModelResultsBuilder(model:Model, structuresBuilder:StructuresBuilder, treeBuilder:ModelTreeBuilder, settings:FitSettings,
                store:FitStore)
        {
            _model = model;
            _structuresBuilder = structuresBuilder;
            _settings = settings;
            this.treeBuilder = treeBuilder;
            if (model.data.cooked != null)
            {
                takeFrom(model.data.cooked);
            }
            _store = isComplete ? null : store;
            if (_store != null)
            {
                add(_geometry.addingGeometry(model.vertices, model.triangles)).begin(readingStored);
            }
            if (structuresBuilder != null)
            {
                add(structuresBuilder);
            }
            if (treeBuilder != null)
            {
                begin(buildingTree);
            }
            call(storeResults);
        }

        /** The structures, when no step is left; null if none were wanted. */
        public function get structures():ModelStructures
        {
            return _structuresBuilder == null ? null : _structuresBuilder.structures;
        }

        /**
         * Makes a cooked file of the model, including the surface. Call it when no step is left. A surface that is missing is prepared now.
         *
         * @param settings of the model's section: see <code>CookedFile.settingsOfLoad()</code>
         */
        public function toCooked(settings:Fingerprint):ByteArray
        {
            if (treeBuilder != null)
            {
                treeBuilder.finishTree().prepare();
            }
            return newFile(settings, CookedWriter.of(_model));
        }

        // Whether all results that are wanted are there.
        private function get isComplete():Boolean
        {
            return (_structuresBuilder == null || structures != null) && (treeBuilder == null || treeBuilder.isStored)
                && (!_settings.wantsSurface || _model.triangles == null || treeBuilder.modelTree.surface != null);
        }

        // Takes results that are missing from a file. Whether the geometry is the model's is not checked, because the file's checksum
        // guarantees that.
        private function takeFrom(file:CookedFile):void
        {
            var size:Number = VertexBounds.of(_model.vertices).largest;
            if (size > VertexBounds.LARGEST_COORDINATE)
            {
                // no fitter accepts such a model, so the record is wrong
                return;
            }
            if (_structuresBuilder != null && structures == null)
            {
                takeStructures(file, size);
            }
            if (treeBuilder != null)
            {
                takeTree(file);
            }
        }

        // The file must have all structures that are wanted.
        private function takeStructures(file:CookedFile, size:Number):void
        {
            var found:Vector.<BoundingStructure> = CookedStructures.read(_settings.sectionOf(file, CookedFile.STRUCTURES), BoundingStructure.BOX, size);
            var hulls:Vector.<BoundingStructure> = _structuresBuilder.wantsHull
                ? CookedStructures.read(_settings.sectionOf(file, CookedFile.HULL), BoundingStructure.HULL, size) : null;
            if (found != null && (hulls != null || !_structuresBuilder.wantsHull))
            {
                // The smallest sphere may be in the hull's place.
                _structuresBuilder.useStored(found, hulls == null ? null : hulls[BoundingStructure.HULL] || hulls[BoundingStructure.SPHERE]);
            }
        }

        private function takeTree(file:CookedFile):void
        {
            var tree:ByteArray = _settings.sectionOf(file, CookedFile.HIERARCHY);
            var bytes:ByteArray = _settings.sectionOf(file, CookedFile.SURFACE);
            var surface:SurfaceTopology = bytes == null || _model.triangles == null ? null : SurfaceTopology.read(bytes, _model.triangles.length / 3);
            if (tree != null && (!treeBuilder.isStored || surface != null && treeBuilder.modelTree.surface == null))
            {
                treeBuilder.useStored(new CookedTree(tree, treeBuilder.modelTree.tree, treeBuilder.maxDepth), surface);
            }
        }

        private function readingStored():Steps
        {
            var stored:CookedFile = _store.fileOf(_geometry, _settings);
            return new StepSequence().add(stored).call(function():void
                {
                    if (stored.isFor(_geometry))
                    {
                        takeFrom(stored);
                    }
                    _isStored = isComplete;
                });
        }

        // A hierarchy that was read is not built until it is needed, unless prepareExact is set.
        private function buildingTree():Steps
        {
            return treeBuilder.isStored && !_settings.wantsSurface ? null : treeBuilder;
        }

        private function storeResults():void
        {
            var isKept:Boolean = _isStored && (treeBuilder == null || treeBuilder.isStored);
            if (_store != null && !isKept && _store.mayHold(_model, treeBuilder != null))
            {
                _store.keep(_geometry, _settings, newFile(_geometry, null));
            }
        }

        // Makes a file of the results. The model's section has these settings and bytes; null if the file is for the store.
        private function newFile(settings:Fingerprint, model:ByteArray):ByteArray
        {
            var contents:Vector.<ByteArray> = new Vector.<ByteArray>(CookedFile.SECTIONS, true);
            contents[CookedFile.MODEL] = model;
            if (structures != null)
            {
                contents[CookedFile.STRUCTURES] = CookedStructures.write(structures.smallest);
                contents[CookedFile.HULL] = structures.hull == null ? null : CookedStructures.write(new <BoundingStructure>[structures.hull]);
            }
            if (treeBuilder != null)
            {
                var made:ModelTree = treeBuilder.finishTree();
                contents[CookedFile.HIERARCHY] = CookedTree.write(made.tree);
                if (made.isPrepared)
                {
                    contents[CookedFile.SURFACE] = CookedFile.newBytes();
                    made.surface.writeTo(contents[CookedFile.SURFACE]);
                }
            }
            return _settings.newFile(settings, contents);
        }
    }
}
