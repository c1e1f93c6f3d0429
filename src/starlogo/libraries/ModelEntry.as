// This room has what was computed for each model. A ModelTable has a ModelEntry for each name, and the two libraries show clients a part of it;
// ModelPreparation takes the results from a cooked file or a FitStore (CookedStructures, CookedTree), or has a StructuresBuilder and a BoxTreeBuilder compute
// them. Read this file first, then BoundingStructuresLibrary and ModelPreparation.
package starlogo.libraries
{
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * The data under the name of one shape.
     *
     * @private
     */
    public final class ModelEntry
    {
        private var _table:ModelTable;
        private var _model:Model = null;
        private var _structures:ModelStructures = null;

        private var _tree:ModelTree = null;
        private var _revision:int = 0;
        private var _loadingCount:int = 0;
        private var _loadProblem:String = null;

        /** @param table counts replaced and removed data of all shapes */
        public function ModelEntry(table:ModelTable)
        {
            _table = table;
        }

        /** Increased whenever data under this name is replaced, removed or posed: once for each of the structures, the tree and the model. */
        public function get revision():int
        {
            return _revision;
        }

        /** The model; null if none was added. */
        public function get model():Model
        {
            return _model;
        }

        /** The structures; null if there are none. */
        public function get structures():ModelStructures
        {
            return _structures;
        }

        /** Sets the structures; null for none. */
        public function setStructures(structures:ModelStructures):void
        {
            countIfReplaced(_structures);
            _structures = structures;
        }

        /** Whether there is a hierarchy. Its tree may not be built yet. */
        public function get hasTree():Boolean
        {
            return _tree != null;
        }

        /** The tree whose nodes are the hierarchy; null if there is none. If it is not built yet, builds it. */
        public function builtTree():ModelTree
        {
            if (_tree != null)
            {
                _tree.finishBuilding();
            }
            return _tree;
        }

        /**
         * Replaces everything under this name.
         *
         * @param model null for none
         * @param structures null for none
         * @param tree null for none
         */
        public function replace(model:Model, structures:ModelStructures, tree:ModelTree):void
        {
            _loadProblem = null;
            setStructures(structures);
            setTree(tree);
            countIfReplaced(_model);
            if (_model != null)
            {
                _model.removeListener(followPose);
            }
            _model = model;
            if (_model != null)
            {
                _model.addListener(followPose);
            }
        }

        /** Sets the tree, which may not be built yet; null for none. */
        public function setTree(tree:ModelTree):void
        {
            countIfReplaced(_tree);
            _tree = tree;
        }

        /** Why the last load of a model of this name failed; null if it did not, or if another one has begun or come. */
        public function get loadProblem():String
        {
            return _loadProblem;
        }

        /** Counts one more model of this name that is loading. */
        public function expect():void
        {
            _loadingCount++;
            _loadProblem = null;
        }

        /** Counts one less, if one is loading. @param problem why its load failed; null if it did not */
        public function expectNoMore(problem:String):void
        {
            _loadingCount = Math.max(0, _loadingCount - 1);
            _loadProblem = problem || _loadProblem;
        }

        /** Whether a model of this name is loading. */
        public function get isLoading():Boolean
        {
            return _loadingCount > 0;
        }

        private function followPose():void
        {
            if (hasTree)
            {
                _tree.refit();
            }
            countChange();
        }

        private function countIfReplaced(before:Object):void
        {
            if (before != null)
            {
                countChange();
            }
        }

        private function countChange():void
        {
            _revision++;
            _table.countChange();
        }
    }
}
