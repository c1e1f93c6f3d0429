package starlogo.libraries.cooked
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.data.Fingerprint;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.vertices.VertexBounds;
    import starlogo.libraries.FitSettings;
    import starlogo.libraries.ModelStructures;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.Model;
    import starlogo.solid.ModelTree;
    import starlogo.solid.interior.SurfaceTopology;

    use namespace engine;

    /**
     * The results for a model in a cooked file, as far as some settings want them. A CookedTree restores the tree.
     *
     * @private
     */
    public final class CookedResults
    {
        // A structure's numbers are at most this factor times the model's largest coordinate. Numbers up to 1 are always allowed.
        private static const LARGEST_FACTOR:Number = 10;

        /** The structures; null if they are not wanted, or if the file does not have all that are. */
        public var structures:ModelStructures = null;

        /** The bytes that say how the tree is divided: see CookedTree. Null if they are not wanted, or not there. */
        public var division:ByteArray = null;

        /** The surface; null if there is no division, or no surface in the file. */
        public var surface:SurfaceTopology = null;

        /**
         * Reads the results of a file.
         *
         * @param file must be the model's: a cooked model brought it, or its geometry was compared
         */
        public static function read(file:CookedFile, settings:FitSettings, model:Model):CookedResults
        {
            var results:CookedResults = new CookedResults();
            var size:Number = VertexBounds.of(model.vertices).largest;
            // no fitter accepts a larger model, so its file is wrong
            if (size <= VertexBounds.LARGEST_VERTEX)
            {
                results.structures = readStructures(file, settings, size);
                results.division = sectionOf(file, settings, CookedFile.HIERARCHY);
                var bytes:ByteArray = results.division == null || model.triangles == null ? null : sectionOf(file, settings, CookedFile.SURFACE);
                results.surface = bytes == null ? null : SurfaceTopology.read(bytes, model.triangles.length / 3);
            }
            return results;
        }

        // The bytes of a section. Null if it is empty, has other settings, or is not wanted.
        private static function sectionOf(file:CookedFile, settings:FitSettings, section:int):ByteArray
        {
            var wanted:Fingerprint = settings.fingerprintOf(section);
            return wanted == null ? null : file.section(section, wanted);
        }

        private static function readStructures(file:CookedFile, settings:FitSettings, size:Number):ModelStructures
        {
            var found:Vector.<BoundingStructure> = structuresIn(sectionOf(file, settings, CookedFile.STRUCTURES), BoundingStructure.BOX, size);
            // The smallest sphere may be in the hull's place.
            var hulls:Vector.<BoundingStructure> = structuresIn(sectionOf(file, settings, CookedFile.HULL), BoundingStructure.HULL, size);
            var hull:BoundingStructure = hulls == null ? null : hulls[BoundingStructure.HULL] || hulls[BoundingStructure.SPHERE];
            return found == null || hulls == null && settings.wantsHull ? null : new ModelStructures(found, hull, settings.keepsAll);
        }

        // Reads what writeStructures() has written. Returns a structure, or null, for each kind up to the last one that there may be. Returns null if
        // there are no bytes, or if they have no structure, one that cannot exist, or one much larger than the model's largest coordinate.
        private static function structuresIn(bytes:ByteArray, last:int, largest:Number):Vector.<BoundingStructure>
        {
            if (bytes == null || bytes.length < 4)
            {
                return null;
            }
            var limit:Number = Math.max(1, LARGEST_FACTOR * largest);
            // a structure of each kind, which receives the numbers
            var o:Vector3D = new Vector3D();
            var all:Vector.<BoundingStructure> = new <BoundingStructure>[new Sphere(o, 0), new Capsule(o, o, 0),
                    new Box(o, Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0), new Hull(new <Number>[0, 0, 0])];
            var kinds:int = bytes.readInt();
            all.length = last + 1;
            for (var kind:int = 0; kind <= last; kind++)
            {
                if ((kinds >> kind & 1) == 0)
                {
                    all[kind] = null;
                }
                else if (!readNumbers(all[kind], bytes, limit))
                {
                    return null;
                }
            }
            return kinds > 0 && kinds >> all.length == 0 && bytes.bytesAvailable == 0 ? all : null;
        }

        // Returns whether the bytes have the numbers of such a structure.
        private static function readNumbers(structure:BoundingStructure, bytes:ByteArray, limit:Number):Boolean
        {
            var numbers:Vector.<Number> = new Vector.<Number>();
            var count:int = structure.kind == BoundingStructure.HULL ? (bytes.bytesAvailable < 4 ? 0 : bytes.readInt()) : structure.numbers().length;
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
                // Numbers that make no structure are refused: by a hull's setNumbers(), by the constructors that clone() calls, or below, if a
                // box's constructor has made its axes perpendicular and unit vectors, and has changed more than their last bits.
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

        /**
         * Makes the bytes of a file with results.
         *
         * @param structures null for none
         * @param tree built; null for none. If its surface is prepared, the file has that too
         * @param settings the settings of the results
         * @param modelKey see <code>CookedFile.MODEL</code>
         * @param model the bytes of the model; null for none
         */
        public static function write(structures:ModelStructures, tree:ModelTree, settings:FitSettings, modelKey:Fingerprint, model:ByteArray):ByteArray
        {
            var contents:Vector.<ByteArray> = new Vector.<ByteArray>(CookedFile.SECTIONS, true);
            contents[CookedFile.MODEL] = model;
            if (structures != null)
            {
                contents[CookedFile.STRUCTURES] = writeStructures(structures.smallest);
                var hull:BoundingStructure = structures.hullOrSphere;
                contents[CookedFile.HULL] = hull == null ? null : writeStructures(new <BoundingStructure>[hull]);
            }
            if (tree != null)
            {
                contents[CookedFile.HIERARCHY] = CookedTree.write(tree.boxTree);
                if (tree.isExactPrepared)
                {
                    contents[CookedFile.SURFACE] = CookedFile.newBytes();
                    tree.surface.writeTo(contents[CookedFile.SURFACE]);
                }
            }
            var fingerprints:Vector.<Fingerprint> = new Vector.<Fingerprint>();
            for (var section:int = 0; section < CookedFile.SECTIONS; section++)
            {
                fingerprints.push(section == CookedFile.MODEL ? modelKey : settings.fingerprintOf(section));
            }
            return CookedFile.write(fingerprints, contents);
        }

        /**
         * Writes structures: first a bit for each kind, whether there is a structure; then the numbers of the structures. A hull's numbers
         * come after their count.
         *
         * @param structures at most one of each kind, in the order of their kinds; null entries are left out
         */
        public static function writeStructures(structures:Vector.<BoundingStructure>):ByteArray
        {
            var out:ByteArray = CookedFile.newBytes();
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
            return out;
        }
    }
}
