package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.data.Fingerprint;
    import starlogo.engine;
    import starlogo.geometry.VertexBounds;
    import starlogo.hierarchy.BoxTree;
    import starlogo.libraries.cooked.CookedStructures;
    import starlogo.libraries.cooked.CookedTree;
    import starlogo.models.Model;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedWriter;
    import starlogo.solid.ModelTree;
    import starlogo.solid.SurfaceTopology;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The work that finds the results for one model. It takes what is in the model's cooked file, otherwise what is in a store, and computes
     * what is missing. Then it stores the results. A hierarchy whose division is stored is not built until it is needed, unless its surface is
     * wanted too.
     *
     * @private
     */
    public final class ModelResults extends StepSequence
    {
        /** The structures. Null if none are wanted, or if they are not there yet. */
        public var structures:ModelStructures = null;

        /** The tree of the hierarchy; null if none is wanted. It may have no nodes yet when this work has no step left. */
        public var modelTree:ModelTree = null;

        /** The work that makes the tree, which may have steps left then. */
        public var buildingTree:Steps = null;

        private var _model:Model;
        private var _structuresBuilder:StructuresBuilder = null;

        // Whether a hull is wanted too, and whether clients may read the smallest structure of each kind.
        private var _wantsHull:Boolean = false;
        private var _keepsAll:Boolean = false;

        // the deepest level of the hierarchies
        private var _maxDepth:int = 0;

        // For stored results: their settings, and where results are kept; null if there are none.
        private var _settings:FitSettings = null;
        private var _store:FitStore;

        // Makes the tree again from a stored division; null for none.
        private var _cookedTree:CookedTree = null;

        // For the store: the fingerprint of the model's vertices and triangles, and whether all results have come from there.
        private var _geometry:Fingerprint = new Fingerprint();
        private var _isStored:Boolean = false;

        /**
         * @param model the model
         * @param structuresLibrary wants structures; null if none are wanted. Its settings count as they are now
         * @param hierarchiesLibrary wants a hierarchy; null if none is wanted. Its settings count as they are now
         * @param store null for none
         */
        public function ModelResults(model:Model, structuresLibrary:BoundingStructuresLibrary, hierarchiesLibrary:HierarchiesLibrary, store:FitStore)
        {
            _model = model;
            if (store != null || model.data.cooked != null)
            {
                _settings = new FitSettings(structuresLibrary, hierarchiesLibrary);
            }
            if (structuresLibrary != null)
            {
                _structuresBuilder = structuresLibrary.newBuilder(model.name, model.vertices);
                _wantsHull = structuresLibrary.keepHulls;
                _keepsAll = structuresLibrary.keepAll;
            }
            if (hierarchiesLibrary != null)
            {
                modelTree = new ModelTree(new BoxTree(model.vertices, model.triangles));
                buildingTree = hierarchiesLibrary.building(modelTree, restoringTree);
                _maxDepth = hierarchiesLibrary.maxDepth;
            }
            if (model.data.cooked != null)
            {
                takeFrom(model.data.cooked);
            }
            _store = store == null || isComplete ? null : store;
            if (_store != null)
            {
                add(_geometry.addingGeometry(model.vertices, model.triangles)).begin(readingStored);
            }
            begin(findingStructures).call(takeStructures).begin(beginningTree);
            if (_store != null)
            {
                begin(beginningStoredTree).call(keepResults);
            }
        }

        /** Whether the hierarchy is made from a stored division. It becomes false if the division does not fit the model. */
        public function get isTreeStored():Boolean
        {
            return _cookedTree != null && !_cookedTree.isRefused;
        }

        /**
         * Makes a cooked file of the model, including the surface. Call it when no step is left. A surface that is missing is prepared now.
         *
         * @param settings the settings of the results
         * @param modelKey the key of the model's section: see <code>CookedFile.settingsOfLoad()</code>
         */
        public function toCooked(settings:FitSettings, modelKey:Fingerprint):ByteArray
        {
            if (modelTree != null)
            {
                finish(buildingTree);
                modelTree.prepareExact();
            }
            return bytesOfFile(settings, modelKey, CookedWriter.of(_model));
        }

        // Whether all results that are wanted are there, or stored. For stored results.
        private function get isComplete():Boolean
        {
            return (_structuresBuilder == null || structures != null) && (modelTree == null || isTreeStored)
                && (!_settings.wantsSurface || _model.triangles == null || modelTree.surface != null);
        }

        private function readingStored():Steps
        {
            var stored:CookedFile = _store.fileOf(_geometry, _settings);
            return new StepSequence().add(stored).call(function():void
                {
                    if (stored.isOf(_geometry))
                    {
                        takeFrom(stored);
                    }
                    _isStored = isComplete;
                });
        }

        private function findingStructures():Steps
        {
            return structures == null ? _structuresBuilder : null;
        }

        private function takeStructures():void
        {
            if (_structuresBuilder != null && structures == null)
            {
                structures = new ModelStructures(_structuresBuilder.found, _structuresBuilder.hull, _keepsAll);
            }
        }

        private function restoringTree():Steps
        {
            return _cookedTree;
        }

        private function beginningTree():Steps
        {
            return isTreeStored && !_settings.wantsSurface ? null : buildingTree;
        }

        // A tree that will be stored has to be built, even if its division came from a cooked model.
        private function beginningStoredTree():Steps
        {
            return willStore ? buildingTree : null;
        }

        private function keepResults():void
        {
            if (willStore)
            {
                _store.keep(_geometry, _settings, bytesOfFile(_settings, _geometry, null));
            }
        }

        // Whether the results will be stored. They are not if all have come from the store.
        private function get willStore():Boolean
        {
            return !(_isStored && (modelTree == null || isTreeStored)) && _store.hasRoomFor(_model, modelTree != null);
        }

        // Takes results that are missing from a file. The callers know that it is the model's: a cooked model brought it, or its geometry was
        // compared.
        private function takeFrom(file:CookedFile):void
        {
            var size:Number = VertexBounds.of(_model.vertices).largest;
            if (size > VertexBounds.LARGEST_VERTEX)
            {
                // no fitter accepts such a model, so the file is wrong
                return;
            }
            if (_structuresBuilder != null && structures == null)
            {
                readStructures(file, size);
            }
            if (modelTree != null)
            {
                readTree(file);
            }
        }

        // The file must have all structures that are wanted.
        private function readStructures(file:CookedFile, size:Number):void
        {
            var found:Vector.<BoundingStructure> = CookedStructures.read(_settings.sectionOf(file, CookedFile.STRUCTURES), BoundingStructure.BOX, size);
            var hulls:Vector.<BoundingStructure> = _wantsHull
                ? CookedStructures.read(_settings.sectionOf(file, CookedFile.HULL), BoundingStructure.HULL, size) : null;
            if (found != null && (hulls != null || !_wantsHull))
            {
                // The smallest sphere may be in the hull's place.
                structures = new ModelStructures(found, hulls == null ? null : hulls[BoundingStructure.HULL] || hulls[BoundingStructure.SPHERE],
                        _keepsAll);
            }
        }

        private function readTree(file:CookedFile):void
        {
            var division:ByteArray = _settings.sectionOf(file, CookedFile.HIERARCHY);
            var bytes:ByteArray = _settings.sectionOf(file, CookedFile.SURFACE);
            var surface:SurfaceTopology = bytes == null || _model.triangles == null ? null : SurfaceTopology.read(bytes, _model.triangles.length / 3);
            if (division != null && (_cookedTree == null || surface != null && modelTree.surface == null))
            {
                _cookedTree = new CookedTree(division, modelTree.boxTree, _maxDepth);
                modelTree.surface = surface;
            }
        }

        // Makes a file of the results. The tree must be built. The key and the bytes are those of the model's section. For the store, these are
        // the fingerprint of the geometry, and null.
        private function bytesOfFile(settings:FitSettings, modelKey:Fingerprint, model:ByteArray):ByteArray
        {
            var contents:Vector.<ByteArray> = new Vector.<ByteArray>(CookedFile.SECTIONS, true);
            contents[CookedFile.MODEL] = model;
            if (structures != null)
            {
                contents[CookedFile.STRUCTURES] = CookedStructures.write(structures.smallest);
                contents[CookedFile.HULL] = structures.hull == null ? null : CookedStructures.write(new <BoundingStructure>[structures.hull]);
            }
            if (modelTree != null)
            {
                contents[CookedFile.HIERARCHY] = CookedTree.write(modelTree.boxTree);
                if (modelTree.hasInterior)
                {
                    contents[CookedFile.SURFACE] = CookedFile.newBytes();
                    modelTree.surface.writeTo(contents[CookedFile.SURFACE]);
                }
            }
            return settings.bytesOfFile(modelKey, contents);
        }
    }
}
