package starlogo.libraries
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.VertexBounds;
    import starlogo.libraries.cooked.TreeWriter;
    import starlogo.models.Model;
    import starlogo.models.cooked.CookedFile;
    import starlogo.solid.SolidHierarchy;
    import starlogo.solid.SurfaceTopology;

    use namespace engine;

    /**
     * The results that were computed for a model: the smallest structures, the division of the items in the hierarchy, and the surface. A
     * cooked file contains them (docs/cooked.md). A FitStore keeps them in a cooked file without a model. A checksum protects both.
     */
    public final class ModelFits
    {
        // A structure's numbers are at most this factor times the model's largest coordinate. Numbers up to 1 are always allowed.
        private static const LARGEST_FACTOR:Number = 10;

        /**
         * The smallest structure of each kind, or null. The index is the kind's number. The list is null if there are no structures.
         *
         * @private
         */
        engine var structures:Vector.<BoundingStructure> = null;

        /**
         * The hull, or the sphere in its place; null if there is none.
         *
         * @private
         */
        engine var hull:BoundingStructure = null;

        /**
         * The bytes that a TreeWriter wrote, from the position on; null if there is no hierarchy.
         *
         * @private
         */
        engine var tree:ByteArray = null;

        /**
         * The surface for exact tests; null if it was not prepared.
         *
         * @private
         */
        engine var surface:SurfaceTopology = null;

        /** Empty. GreatLand and FitStore make them. */
        public function ModelFits()
        {
        }

        /** Whether it has structures. */
        public function get hasStructures():Boolean
        {
            return structures != null;
        }

        /** Whether it has a hull, or the sphere in its place. */
        public function get hasHull():Boolean
        {
            return hull != null;
        }

        /** Whether it has a hierarchy. */
        public function get hasHierarchy():Boolean
        {
            return tree != null;
        }

        /** Whether it has the surface for exact colliders. */
        public function get hasSurface():Boolean
        {
            return surface != null;
        }

        /**
         * The results that the libraries have for a model.
         *
         * @param shape null if there are no structures
         * @param hierarchy null if there is none
         *
         * @private
         */
        engine static function of(shape:ShapeStructures, hierarchy:SolidHierarchy):ModelFits
        {
            var fits:ModelFits = new ModelFits();
            fits.structures = shape == null ? null : shape.smallest;
            fits.hull = shape == null ? null : shape.hull;
            if (hierarchy != null)
            {
                fits.tree = CookedFile.newBytes();
                TreeWriter.write(hierarchy.tree, fits.tree);
                fits.tree.position = 0;
                fits.surface = hierarchy.isPrepared ? hierarchy.surface : null;
            }
            return fits;
        }

        /**
         * Takes the fits of a cooked file, and keeps those that are already here. It ignores sections of other settings and sections with
         * impossible numbers. It does not check whether the geometry is the model's, because the file's checksum guarantees that.
         *
         * @param file all its steps must be done
         * @param model the model
         * @param settings the settings of the wanted fits
         *
         * @private
         */
        engine function readFrom(file:CookedFile, model:Model, settings:FitSettings):void
        {
            var bounds:VertexBounds = VertexBounds.of(model.vertices);
            if (bounds.largest > VertexBounds.LARGEST_COORDINATE)
            {
                // no fitter accepts such a model, so the record is wrong
                return;
            }
            var limit:Number = Math.max(1, LARGEST_FACTOR * bounds.largest);
            if (settings.structures != null)
            {
                structures ||= readStructures(file.section(CookedFile.STRUCTURES, settings.structures), BoundingStructure.BOX, limit);
            }
            if (settings.hull != null)
            {
                hull ||= firstOf(readStructures(file.section(CookedFile.HULL, settings.hull), BoundingStructure.HULL, limit));
            }
            if (settings.hierarchy == null)
            {
                return;
            }
            var bytes:ByteArray = file.section(CookedFile.SURFACE, settings.hierarchy);
            var read:SurfaceTopology = bytes == null ? null : SurfaceTopology.read(bytes, model.triangles == null ? 0 : model.triangles.length / 3);
            if (tree == null || surface == null && read != null)
            {
                tree = file.section(CookedFile.HIERARCHY, settings.hierarchy);
                surface = read;
            }
        }

        /**
         * Makes the bytes of a cooked file.
         *
         * @param settings the settings with which the fits were computed
         * @param wanted the fingerprint of the model's arguments
         * @param shape the section of the model; null if the model is read from elsewhere
         *
         * @private
         */
        engine function toFile(settings:FitSettings, wanted:Fingerprint, shape:ByteArray = null):ByteArray
        {
            var ofStructures:ByteArray = CookedFile.newBytes();
            var ofHull:ByteArray = CookedFile.newBytes();
            var ofTree:ByteArray = CookedFile.newBytes();
            var ofSurface:ByteArray = CookedFile.newBytes();
            if (structures != null && settings.structures != null)
            {
                writeStructures(structures, ofStructures);
            }
            if (hull != null && settings.hull != null)
            {
                writeStructures(new <BoundingStructure>[hull], ofHull);
            }
            if (tree != null && settings.hierarchy != null)
            {
                ofTree.writeBytes(tree);
                if (surface != null)
                {
                    surface.writeTo(ofSurface);
                }
            }
            return CookedFile.write(new <Fingerprint>[wanted, settings.structures, settings.hierarchy, settings.hierarchy, settings.hull],
                    new <ByteArray>[shape || CookedFile.newBytes(), ofStructures, ofTree, ofSurface, ofHull]);
        }

        // First a bit for each kind: whether there is a structure. Then the numbers of the structures. A hull's come after their count.
        private static function writeStructures(structures:Vector.<BoundingStructure>, out:ByteArray):void
        {
            var kinds:int = 0;
            out.writeInt(0);
            for each (var structure:BoundingStructure in structures)
            {
                if (structure == null)
                {
                    continue;
                }
                kinds |= 1 << structure.kind;
                var numbers:Vector.<Number> = structure.numbers();
                if (structure.kind == BoundingStructure.HULL)
                {
                    out.writeInt(numbers.length);
                }
                for each (var number:Number in numbers)
                {
                    out.writeDouble(number);
                }
            }
            out.position = 0;
            out.writeInt(kinds);
        }

        // Reads structures of all kinds up to the last one.
        private static function readStructures(bytes:ByteArray, last:int, limit:Number):Vector.<BoundingStructure>
        {
            var o:Vector3D = new Vector3D();
            var read:Vector.<BoundingStructure> = new <BoundingStructure>[new Sphere(o, 0), new Capsule(o, o, 0),
                    new Box(o, Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0), new Hull(new <Number>[0, 0, 0])];
            var kinds:int = bytes == null || bytes.length < 4 ? 0 : bytes.readInt();
            read.length = last + 1;
            for (var kind:int = 0; kind <= last; kind++)
            {
                if ((kinds >> kind & 1) == 0)
                {
                    read[kind] = null;
                }
                else if (!readNumbers(read[kind], bytes, limit))
                {
                    return null;
                }
            }
            return kinds > 0 && kinds >> read.length == 0 && bytes.bytesAvailable == 0 ? read : null;
        }

        // The first structure of a list; null if there is no list.
        private static function firstOf(structures:Vector.<BoundingStructure>):BoundingStructure
        {
            for each (var structure:BoundingStructure in structures)
            {
                if (structure != null)
                {
                    return structure;
                }
            }
            return null;
        }

        // Returns whether the bytes have the numbers of such a structure.
        private static function readNumbers(structure:BoundingStructure, bytes:ByteArray, limit:Number):Boolean
        {
            var numbers:Vector.<Number> = new Vector.<Number>();
            var count:int = structure.kind == BoundingStructure.HULL ? readCount(bytes) : structure.numbers().length;
            var areRight:Boolean = count > 0 && bytes.bytesAvailable / 8 >= count;
            for (var i:int = 0; i < count && areRight; i++)
            {
                numbers.push(bytes.readDouble());
                areRight = Math.abs(numbers[i]) <= limit;
            }
            if (!areRight)
            {
                return false;
            }
            try
            {
                // Both refuse numbers that make no structure. The constructor straightens a box's axes, which changes their last bits only.
                structure.setNumbers(numbers);
                var made:Vector.<Number> = structure.clone().numbers();
            }
            catch (error:Error)
            {
                return false;
            }
            for (i = 0; i < count && areRight; i++)
            {
                areRight = made.length == count && Math.abs(made[i] - numbers[i]) <= 100 * Tolerances.ROUNDING;
            }
            return areRight;
        }

        private static function readCount(bytes:ByteArray):int
        {
            return bytes.bytesAvailable < 4 ? 0 : bytes.readInt();
        }
    }
}
